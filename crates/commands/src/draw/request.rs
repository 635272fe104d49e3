//! The command `draw`: pictures of gearboxes and hydromotors as SVG, DXF, PDF and PNG.

use crate::desk::Call;
use crate::motor::table::View as MotorView;
mod subject;

use crate::answer::to_json;
use crate::draw::answer::{self as answers, Drawing, FileFormat, Sheet, View};
use crate::draw::table as draw;
use crate::drawing_file;
use crate::failure::Failure;
use crate::input;
use crate::losses::table::efficiency_map;
use crate::motor::answer::of_file;
use crate::motor::options as motor;
use crate::shared::drawability::answer::Conflict;
use crate::shared::gearbox_choice::{self as analyze, Choice, analysis};
use crate::shared::named_gearbox as named;
use crate::shared::places::Grid;
use crate::shared::tooth_checks::answer::ToothChecks;
use epicyclic_drawing::{Scene, svg};
use epicyclic_formats::{self as formats, Document};
use epicyclic_layout as drawability;
use epicyclic_layout::{Layout, Verdict};
use epicyclic_pictures::gearbox::{ladder, levers, scheme, speeds};
use epicyclic_pictures::toothed_sets::{self, ToothedSet};
use epicyclic_train::planet_bearings::PlanetBearing;
use epicyclic_train::{Analysis, Gearbox};
use epicyclic_units::{Number, Physical as _, Quantity};
use std::path::{Path, PathBuf};
use subject::Subject;
use uom::si::f64::{Length, Ratio};

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
    /// A scheme of the catalogue, a structure as `select` names it (D.T1.B+T2.B.T1), or the file of a gearbox
    /// or motor in YAML; - for standard input.
    #[arg(value_name = "GEARBOX", value_hint = clap::ValueHint::FilePath)]
    gearbox: String,

    /// What is drawn.
    ///
    /// Default: the scheme of a gearbox, the whole motor of a motor's file.
    #[arg(long, value_enum)]
    view: Option<View>,

    /// One transmission of a list: its name, or a part that no other name has.
    #[arg(long, value_name = "NAME")]
    transmission: Option<String>,

    /// One gear: engaged shift elements are filled, links at rest are grey.
    #[arg(long, value_name = "NAME")]
    gear: Option<String>,

    /// The width of each line of the scheme shows the power through it.
    #[arg(long, requires = "gear")]
    power: bool,

    /// Both halves of the scheme, the lower a mirror image.
    #[arg(long)]
    whole: bool,

    /// Input and output of the scheme on the left.
    #[arg(long)]
    same_side: bool,

    /// Gears and planet axes of the scheme at heights in proportion to their pitch radii; needs k or teeth.
    ///
    /// Sets with module and teeth are in one scale, which the picture names with a scale bar; without modules
    /// all are taken as equal. Widths along the axis are not to scale, and shafts and drums stand where there
    /// is room.
    #[arg(long)]
    to_scale: bool,

    #[command(flatten)]
    map: Grid,

    #[command(flatten)]
    sizes: named::Sizes,

    /// With --power: efficiency with the carrier fixed of each set for which no losses are stated. Default:
    /// no losses.
    #[arg(long, value_name = "NUMBER", requires = "power", allow_hyphen_values = true)]
    efficiency: Option<Quantity<Ratio>>,

    /// Title in place of the gearbox's name and gear.
    #[arg(long)]
    title: Option<String>,

    /// File for the drawing, by the end of its name: .dxf, .pdf, .png, otherwise SVG. Default: SVG on
    /// standard output.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Pixels to an inch of a PNG image, 20 to 2400; an image has at most 100 million pixels. Default: 300.
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

/// What goes to standard output.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// A line for each file; without a file the drawing as SVG.
    Text,
    /// JSON: what is drawn and how, its size in SI units, its files, or what cannot be drawn together.
    Json,
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

/// Drawing of the answer with its picture, or the reason why no picture exists.
struct Picture {
    drawing: Drawing,
    scene: Result<Scene, Failure>,
    /// Place of the gearbox in its file.
    base: formats::Path,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let file = Path::new(&args.gearbox);
    let document = input::exists(call, file).then(|| input::document(call, file)).transpose()?;
    let Picture { mut drawing, scene, base } = match &document {
        Some(document) if is_motor(document) => of_motor(args, document)?,
        _ => of_gearbox(call, args, document.as_ref())?,
    };
    let placed = |failure: Failure| match &document {
        Some(document) => failure.in_file(document, &base),
        None => failure,
    };
    let scene = scene.map_err(placed);
    if let (Err(Failure::SelfCrossing { conflict, .. }), Format::Json) = (&scene, args.format) {
        drawing.conflict = Some((**conflict).clone());
        call.say(&to_json(&drawing)?)?;
    }
    let scene = scene?;
    let mut files: Vec<(&Path, FileFormat)> = vec![];
    if let Some(file) = args.output.as_deref() {
        files.push((file, drawing_file::format_by_name(file, "--output")?));
    }
    drawing_file::check_dpi(args.dpi, files.iter().map(|(_, format)| *format))?;
    files.extend(args.svg.as_deref().map(|file| (file, FileFormat::Svg)));
    files.extend(args.dxf.as_deref().map(|file| (file, FileFormat::Dxf)));
    if args.format == Format::Text {
        for warning in drawing.tooth_checks.iter().flat_map(ToothChecks::warnings) {
            call.complain(&format!("warning: {}", warning.message));
        }
    }
    if files.is_empty() && args.format == Format::Text {
        return call.say(&(svg::write(&scene).map_err(|error| placed(error.into()))? + "\n"));
    }
    let mut written = vec![];
    for (file, format) in files {
        let content = drawing_file::content(&scene, format, args.dpi).map_err(placed)?;
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

/// The drawing that the options describe, before it is made.
fn drawing(args: &Args, subject: answers::Subject, view: View, gear: Option<&str>) -> Drawing {
    Drawing {
        subject,
        view,
        gear: gear.map(str::to_owned),
        power: args.power,
        whole: args.whole,
        same_side: args.same_side,
        to_scale: args.to_scale,
        sheet: None,
        conflict: None,
        files: vec![],
        tooth_checks: None,
    }
}

fn is_motor(document: &Document) -> bool {
    ["stator", "rotor"].iter().any(|key| document.value().get(key).is_some())
}

fn of_motor(args: &Args, document: &Document) -> Result<Picture, Failure> {
    let of_gearboxes = [
        ("--transmission", args.transmission.is_some()),
        ("--gear", args.gear.is_some()),
        ("--speeds", args.map.is_given()),
        ("--power", args.power),
        ("--whole", args.whole),
        ("--same-side", args.same_side),
        ("--to-scale", args.to_scale),
        ("--efficiency", args.efficiency.is_some()),
        ("--title", args.title.is_some()),
    ];
    let given = of_gearboxes.into_iter().find(|(_, is_given)| *is_given).map(|(option, _)| option);
    if let Some(option) = given.or(args.sizes.given()) {
        return Err(Failure::conflict(option, "it is for gearboxes; this is a motor"));
    }
    let view = args.view.unwrap_or(View::Motor);
    let Some(of_motor) = of_motor_view(view) else {
        let message =
            "a motor has the views centrodes, construction, teeth, motor, chambers, dimensions".to_owned();
        return Err(Failure::invalid("--view", message));
    };
    let base = formats::Path::root();
    let (title, designed) =
        of_file(document).map_err(|error| Failure::from(error).in_file(document, &base))?;
    let subject = answers::Subject::of_motor(title, &designed.motor);
    let drawing = drawing(args, subject, view, None);
    Ok(Picture { drawing, scene: motor::files::scene(of_motor, &designed), base })
}

fn of_gearbox(call: &Call<'_>, args: &Args, document: Option<&Document>) -> Result<Picture, Failure> {
    consistent(args)?;
    let subject = subject::read(call, args, document)?;
    let mut drawing =
        drawing(args, subject.record(), args.view.unwrap_or(View::Scheme), args.gear.as_deref());
    let scene = match (args.view, document) {
        (Some(View::Map), Some(document)) => map(args, document),
        (Some(View::Map), None) => {
            let message = "a map is of a gearbox's file, which states its losses".to_owned();
            Err(Failure::invalid("--view", message))
        }
        _ => scene(args, &subject),
    };
    if args.view == Some(View::Teeth) {
        drawing.tooth_checks.clone_from(&subject.tooth_checks);
    }
    let base = if scene.is_err() { subject.of_fault(args.view) } else { subject.base };
    Ok(Picture { drawing, scene, base })
}

/// Refuses options that say nothing for the view.
fn consistent(args: &Args) -> Result<(), Failure> {
    let refuse = |option, message: &str| Err(Failure::conflict(option, message));
    let schemes_alone = "only the view scheme has it";
    let view = args.view.unwrap_or(View::Scheme);
    if args.map.is_given() && view != View::Map {
        return refuse("--speeds", "only the view map has it");
    }
    match view {
        View::Scheme => Ok(()),
        view if view != View::Teeth && of_motor_view(view).is_some() => {
            refuse("--view", "a gearbox has the views scheme, speeds, levers, ladder, teeth, map")
        }
        _ if args.power => refuse("--power", schemes_alone),
        _ if args.whole => refuse("--whole", schemes_alone),
        _ if args.same_side => refuse("--same-side", schemes_alone),
        _ if args.to_scale => refuse("--to-scale", schemes_alone),
        View::Map if !args.map.is_given() => {
            refuse("--speeds", "a map stands over --speeds and --torques of a gear; give both")
        }
        View::Speeds if args.gear.is_none() => refuse("--gear", "a speed diagram shows one gear; name it"),
        View::Teeth if args.gear.is_some() => {
            refuse("--gear", "the teeth stand alike in all gears; leave it out")
        }
        View::Ladder if args.gear.is_some() => refuse("--gear", "the ladder shows all gears; leave it out"),
        _ => Ok(()),
    }
}

fn scene(args: &Args, subject: &Subject) -> Result<Scene, Failure> {
    let gearbox = &subject.gearbox;
    let title = args.title.as_deref();
    let gear = args.gear.as_deref().map(|gear| analysis(gearbox, gear)).transpose()?;
    Ok(match (args.view.unwrap_or(View::Scheme), &gear) {
        (View::Scheme, gear) => kinematic(args, subject, gear.as_ref())?,
        (View::Speeds, Some(gear)) => speeds::scene(gearbox, gear, title)?,
        (View::Teeth, _) => toothed(subject, title)?,
        (View::Levers, gear) => levers::scene(gearbox, gear.as_ref(), title)?,
        // `consistent` leaves the ladder alone.
        _ => ladder::scene(gearbox, &all_gears(gearbox)?, title)?,
    })
}

/// The efficiency of a gear over speed and torque.
fn map(args: &Args, document: &Document) -> Result<Scene, Failure> {
    let choice = Choice::new(args.gearbox.clone(), args.transmission.clone(), args.efficiency);
    let subject = analyze::subject(&choice, document)?;
    let (Some(gear), Some((speeds, torques))) = (args.gear.as_deref(), args.map.places()) else {
        // `consistent` asks for them.
        return Err(Failure::missing("--gear", "a map is of one gear; name it"));
    };
    let found = crate::losses::answer::map(&subject, gear, &speeds, &torques).map_err(analyze::refuse)?;
    let picture = efficiency_map(&found, args.title.as_deref());
    Ok(picture.scene().map_err(epicyclic_pictures::Error::from)?)
}

/// The simple sets whose teeth are known, in mesh; a millimetre for a module where the file has none.
fn toothed(subject: &Subject, title: Option<&str>) -> Result<Scene, Failure> {
    let gearbox = &subject.gearbox;
    let mut sets = vec![];
    for set in gearbox.sets() {
        let Some(gears) = set.short().and_then(|spec| spec.toothed_set(&subject.rack)) else { continue };
        let module = subject.modules.get(set.id()).copied().unwrap_or_else(|| Length::from_mm(1.0));
        let set = gears.map(|gears| ToothedSet { name: set.id().to_owned(), set: gears, module });
        sets.push(set.map_err(epicyclic_pictures::Error::from)?);
    }
    if sets.is_empty() {
        let message = "no set is a simple one whose teeth are known and share a centre distance: give `teeth`, and `planet_teeth` with \
                       `profile_shifts` where it needs them"
            .to_owned();
        return Err(Failure::invalid("--view", message));
    }
    Ok(toothed_sets::scene(title.unwrap_or(gearbox.name()), &sets)?)
}

fn all_gears(gearbox: &Gearbox) -> Result<Vec<Analysis<'_>>, Failure> {
    Ok(gearbox.gears().iter().map(|gear| gearbox.analyze_gear(gear)).collect::<Result<_, _>>()?)
}

/// A layout with gears at the heights of their pitch radii.
pub(crate) fn to_scale(
    gearbox: &Gearbox,
    layout: &Layout,
    bearings: &[PlanetBearing],
) -> Result<(Layout, scheme::Scale), Failure> {
    scheme::to_scale(gearbox, layout, bearings).map_err(|error| match error {
        epicyclic_pictures::Error::NoRadii { .. } | epicyclic_pictures::Error::NotToScale { .. } => {
            Failure::named("not-to-scale", "--to-scale", error.to_string())
        }
        error => error.into(),
    })
}

fn kinematic(args: &Args, subject: &Subject, gear: Option<&Analysis>) -> Result<Scene, Failure> {
    let gearbox = &subject.gearbox;
    let how = drawability::Options { same_side: args.same_side, ..drawability::Options::default() };
    let layout = match drawability::draw(gearbox, how) {
        Verdict::Drawable(layout) => layout,
        Verdict::SelfCrossing(witness) => {
            return Err(Failure::SelfCrossing {
                gearbox: gearbox.name().to_owned(),
                conflict: Box::new(Conflict::of(gearbox, &witness)),
            });
        }
    };
    let shown = match gear {
        None => scheme::Show::Structure,
        Some(gear) if args.power => scheme::Show::Power(gear),
        Some(gear) => scheme::Show::Gear(gear),
    };
    let (layout, scale) = if args.to_scale {
        if !subject.gearing {
            let message = "heights are radii, and these follow from k or teeth of every set: give --k1 and --k2, or --ratio1 and --ratio2";
            return Err(Failure::invalid("--to-scale", message));
        }
        let (layout, scale) = to_scale(gearbox, &layout, &subject.planet_bearings)?;
        (Box::new(layout), Some(scale))
    } else {
        (layout, None)
    };
    let options = scheme::Options {
        title: args.title.clone(),
        whole: args.whole,
        gearing: subject.gearing,
        scale,
        ..scheme::Options::default()
    };
    Ok(scheme::scene(gearbox, &layout, shown, &options)?)
}
