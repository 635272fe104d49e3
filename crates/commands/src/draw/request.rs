//! The command `draw`: pictures of gearboxes and hydromotors as SVG, DXF, PDF and PNG.

mod scenes;

use crate::answer::to_json;
use crate::desk::Call;
use crate::draw::answer::{self as answers, Drawing, FileFormat, Sheet, View};
use crate::draw::table as draw;
use crate::drawing_file;
use crate::failure::Failure;
use crate::motor::answer::{Designed, of_file};
use crate::motor::options as motor;
use crate::motor::table::View as MotorView;
use crate::shared::gearbox::{Gearbox, Origin};
use crate::shared::gearbox_choice::{Choice, subject};
use crate::shared::judgement::answer::Judgement;
use crate::shared::places::Grid;
use crate::shared::tooth_checks::answer::ToothChecks;
use crate::shared::toothed::{AssumedRadius, WithoutTeeth};
use epicyclic_drawing::{Scene, svg};
use epicyclic_formats as formats;
use epicyclic_formats::FileKind;
use epicyclic_units::Dimension::Length;
use epicyclic_units::Number;
use epicyclic_units::format::in_unit;
pub(crate) use scenes::to_scale;
use std::path::{Path, PathBuf};

/// A gearbox as a drawing: its scheme, speed diagram, lever diagram or ratio ladder; a hydromotor from its
/// file.
///
/// The gearbox is a scheme of the catalogue (I … III-3) unless a file has that name, or comes from a file as
/// for `analyze`. The scheme is the section by the half-plane above the axis with the usual symbols. No link
/// crosses another in it; a gearbox for which this is impossible is refused, and the parts in conflict are
/// named. Drawings are in millimetres.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    #[command(flatten)]
    choice: Choice,

    #[command(flatten)]
    request: Request,

    /// File for the drawing, by the end of its name: .dxf, .pdf, .png, otherwise SVG. Default: SVG on
    /// standard output.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Pixels to an inch of a PNG image, 20 to 2400; an image has at most 100 million pixels. Default: 300,
    /// or fewer where the image would have more.
    #[arg(long, value_name = "NUMBER", requires = "output")]
    dpi: Option<Number>,

    /// File for the drawing as SVG.
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,

    /// File for the drawing as DXF, for CAD.
    #[arg(long, value_name = "FILE")]
    dxf: Option<PathBuf>,

    /// What goes to standard output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// Request for a drawing.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Request {
    /// What is drawn.
    ///
    /// Default: the scheme of a gearbox, the whole motor of a motor's file.
    #[arg(long, value_enum)]
    pub view: Option<View>,

    /// One gear: engaged shift elements are filled, links at rest are grey.
    #[arg(long, value_name = "NAME")]
    pub gear: Option<String>,

    /// The width of each line of the scheme shows the power through it.
    #[arg(long, requires = "gear")]
    pub power: bool,

    /// Both halves of the scheme, the lower a mirror image.
    #[arg(long)]
    pub whole: bool,

    /// Input and output of the scheme on the left.
    #[arg(long)]
    pub same_side: bool,

    /// Gears and planet axes of the scheme at heights in proportion to their pitch radii; needs k or teeth.
    ///
    /// Sets with module and teeth are in one scale, which the picture names with a scale bar; without modules
    /// all are taken as equal. Widths along the axis are not to scale, and shafts and drums stand where there
    /// is room.
    #[arg(long)]
    pub to_scale: bool,

    /// Speeds and torques of a map of the efficiency.
    #[command(flatten)]
    pub map: Grid,

    /// Title in place of the gearbox's name and gear.
    #[arg(long)]
    pub title: Option<String>,
}

/// What goes to standard output.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// A line for each file; without a file the drawing as SVG.
    Text,
    /// JSON: what is drawn and how, its size in SI units, its files, or what cannot be drawn together.
    Json,
}

/// A drawing: its record and its lines, arcs and texts.
#[derive(Debug, Clone)]
pub struct Picture {
    /// Record of the drawing.
    pub drawing: Drawing,
    /// Lines, arcs and texts in millimetres.
    pub scene: Scene,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let any_size_will_do = args.request.gear.is_none() && args.request.view() == View::Scheme;
    let read = args.choice.document(call, any_size_will_do)?;
    if read.document.kind() == Some(FileKind::Motor) {
        if let Some(option) = args.choice.given() {
            return Err(of_gearboxes_alone(option));
        }
        let in_file = |failure: Failure| failure.in_file(&read.document, &formats::Path::root());
        let (title, designed) = of_file(&read.document).map_err(|error| in_file(error.into()))?;
        let picture = args.request.of_motor(title, &designed).map_err(in_file)?;
        return write(call, args, picture, in_file);
    }
    args.request.check()?;
    if !args.request.power && args.request.view() != View::Map {
        args.choice.no_efficiency("only --power and the view map show losses; leave it out")?;
    }
    let gearbox = subject(&args.choice, &read)?;
    let in_file = |failure: Failure, base: &formats::Path| match gearbox.origin {
        Origin::GearboxFile => failure.in_file(&gearbox.document, base),
        _ => failure,
    };
    let picture = args.request.of_gearbox(&gearbox).map_err(|failure| {
        let is_teeth = args.request.view() == View::Teeth;
        in_file(failure, &if is_teeth { scenes::of_faulty_teeth(&gearbox) } else { gearbox.base.clone() })
    });
    if let (Err(Failure::SelfCrossing { conflict, .. }), Format::Json) = (&picture, args.format) {
        let drawing = args.request.record(answers::Subject::of_gearbox(&gearbox));
        call.say(&to_json(&Drawing { conflict: Some((**conflict).clone()), ..drawing })?)?;
    }
    write(call, args, picture?, |failure| in_file(failure, &gearbox.base))
}

/// Writes the picture to its files, and what was drawn to standard output.
fn write(
    call: &Call<'_>,
    args: &Args,
    Picture { mut drawing, scene }: Picture,
    in_file: impl Fn(Failure) -> Failure,
) -> Result<(), Failure> {
    let mut files: Vec<(&Path, FileFormat)> = vec![];
    if let Some(file) = args.output.as_deref() {
        files.push((file, drawing_file::format_by_name(file, "--output")?));
    }
    drawing_file::check_dpi(args.dpi, files.iter().map(|(_, format)| *format))?;
    files.extend(args.svg.as_deref().map(|file| (file, FileFormat::Svg)));
    files.extend(args.dxf.as_deref().map(|file| (file, FileFormat::Dxf)));
    if args.format == Format::Text {
        for WithoutTeeth { set, why } in &drawing.left_out {
            call.complain(&format!("warning: set `{set}` is not drawn: {why}"));
        }
        for AssumedRadius { set, planet, radius_m } in &drawing.assumed_radii {
            let radius = radius_m.map(|radius| in_unit(radius, Length.usual_unit(), 4));
            let (at, stated) = match radius {
                Some(radius) => (format!(" at the radius {radius}"), radius),
                None => (String::new(), "…".to_owned()),
            };
            call.complain(&format!(
                "warning: set `{set}`: the planet {planet} meshes with other planets alone and is drawn{at} between them; state `planet_sizes: {{ {planet}: {{ carrier_radius: {stated} }} }}`"
            ));
        }
        for warning in drawing.tooth_checks.iter().flat_map(ToothChecks::warnings) {
            call.complain(&format!("warning: {}", warning.message));
        }
    }
    if files.is_empty() && args.format == Format::Text {
        return call.say(&(svg::write(&scene).map_err(|error| in_file(error.into()))? + "\n"));
    }
    let mut written = vec![];
    for (file, format) in files {
        let content = drawing_file::content(&scene, format, args.dpi).map_err(&in_file)?;
        written.push((file.to_owned(), content));
        drawing.files.push(answers::File { path: file.display().to_string(), format });
    }
    let size = scene.bounds().grown(svg::MARGIN_MM);
    drawing.sheet = Some(Sheet::of(scene.title(), [size.width(), size.height()]));
    let told = match args.format {
        Format::Text => draw::lines(&drawing),
        Format::Json => to_json(&drawing)?,
    };
    call.write(&written)?;
    call.say(&told)
}

fn of_gearboxes_alone(option: &'static str) -> Failure {
    Failure::conflict(option, "it is for gearboxes; this is a motor")
}

impl Request {
    /// Draws a gearbox.
    ///
    /// # Errors
    /// [`Failure::Option`] for options that say nothing for the view, [`Failure::SelfCrossing`] for a gearbox
    /// whose links must cross, [`Failure::Picture`] if a figure that the view shows is not known.
    pub fn of_gearbox(&self, gearbox: &Gearbox) -> Result<Picture, Failure> {
        self.check()?;
        let mut drawing = self.record(answers::Subject::of_gearbox(gearbox));
        drawing.judgement = Judgement::of(gearbox, None, None, None);
        if self.view() == View::Teeth {
            drawing.tooth_checks = Some(ToothChecks::of(gearbox.tooth_checks(), |_| true));
        }
        let scene = scenes::of_gearbox(self, gearbox, &mut drawing)?;
        Ok(Picture { drawing, scene })
    }

    /// Draws a motor; only the view applies to it.
    ///
    /// # Errors
    /// [`Failure::Option`] for options of gearboxes and a view that the motor does not have.
    pub fn of_motor(&self, title: Option<String>, designed: &Designed) -> Result<Picture, Failure> {
        let of_gearboxes = [
            ("--gear", self.gear.is_some()),
            ("--speeds", self.map.is_given()),
            ("--power", self.power),
            ("--whole", self.whole),
            ("--same-side", self.same_side),
            ("--to-scale", self.to_scale),
            ("--title", self.title.is_some()),
        ];
        if let Some((option, _)) = of_gearboxes.into_iter().find(|(_, is_given)| *is_given) {
            return Err(of_gearboxes_alone(option));
        }
        let view = self.view.unwrap_or(View::Motor);
        let Some(of_motor) = of_motor_view(view) else {
            let message = "a motor has the views centrodes, construction, teeth, motor, chambers, dimensions"
                .to_owned();
            return Err(Failure::invalid("--view", message));
        };
        let drawing = self.record(answers::Subject::of_motor(title, &designed.motor));
        let judgement = crate::motor::answer::answer(designed)?.judgement;
        let drawing = Drawing { view, judgement, ..drawing };
        Ok(Picture { drawing, scene: motor::files::scene(of_motor, designed)? })
    }

    /// View of a gearbox.
    fn view(&self) -> View {
        self.view.unwrap_or(View::Scheme)
    }

    /// Record of the drawing before it is made.
    fn record(&self, subject: answers::Subject) -> Drawing {
        Drawing {
            subject,
            view: self.view(),
            gear: self.gear.clone(),
            power: self.power,
            whole: self.whole,
            same_side: self.same_side,
            to_scale: self.to_scale,
            sheet: None,
            conflict: None,
            files: vec![],
            judgement: Judgement::default(),
            tooth_checks: None,
            left_out: vec![],
            assumed_radii: vec![],
        }
    }

    /// Refuses options that say nothing for the view.
    fn check(&self) -> Result<(), Failure> {
        let refuse = |option, message: &str| Err(Failure::conflict(option, message));
        let schemes_alone = "only the view scheme has it";
        let view = self.view();
        if self.map.is_given() && view != View::Map {
            return refuse("--speeds", "only the view map has it");
        }
        match view {
            View::Scheme => Ok(()),
            view if view != View::Teeth && of_motor_view(view).is_some() => {
                refuse("--view", "a gearbox has the views scheme, speeds, levers, ladder, teeth, map")
            }
            _ if self.power => refuse("--power", schemes_alone),
            _ if self.whole => refuse("--whole", schemes_alone),
            _ if self.same_side => refuse("--same-side", schemes_alone),
            _ if self.to_scale => refuse("--to-scale", schemes_alone),
            View::Map if !self.map.is_given() => {
                refuse("--speeds", "a map stands over --speeds and --torques of a gear; give both")
            }
            View::Speeds if self.gear.is_none() => {
                refuse("--gear", "a speed diagram shows one gear; name it")
            }
            View::Teeth if self.gear.is_some() => {
                refuse("--gear", "the teeth stand alike in all gears; leave it out")
            }
            View::Ladder if self.gear.is_some() => {
                refuse("--gear", "the ladder shows all gears; leave it out")
            }
            _ => Ok(()),
        }
    }
}

/// The view of a motor; `None` for those of gearboxes.
fn of_motor_view(view: View) -> Option<MotorView> {
    match view {
        View::Scheme | View::Speeds | View::Levers | View::Ladder | View::Map => None,
        View::Centrodes => Some(MotorView::Centrodes),
        View::Construction => Some(MotorView::Construction),
        View::Teeth => Some(MotorView::Teeth),
        View::Motor => Some(MotorView::Motor),
        View::Chambers => Some(MotorView::Chambers),
        View::Dimensions => Some(MotorView::Dimensions),
        View::Forces => Some(MotorView::Forces),
        View::Ports => Some(MotorView::Ports),
        View::Pressure => Some(MotorView::Pressure),
        View::Stress => Some(MotorView::Stress),
        View::Efficiency => Some(MotorView::Efficiency),
    }
}
