//! The ladder of ratios: all gears on one logarithmic scale, with the steps between them.
//!
//! On a logarithmic scale equal steps `φ = i_n/i_{n+1}` are equal distances, so an even gearbox is an even
//! ladder. Gears of negative ratio turn the output against the input; they are drawn dashed at `|i|`.

use super::place::spread;
use super::words::decimal;
use super::{COLORS, Error, LETTERS_MM, TITLE_MM};
use crate::tolerance::{MARK, SAME_RATIO};
use epicyclic_drawing::{Align, Color, Dash, Scene, Shape, Style, Text};
use epicyclic_train::{Analysis, Gearbox};

/// Height of the scale: of a drawing of its own, and on a page.
const HEIGHTS_MM: [f64; 2] = [100.0, 70.0];
/// Distance of the labels from rung to rung.
const PITCH_MM: f64 = 5.0;

/// A gear on the ladder.
struct Rung<'a> {
    name: &'a str,
    ratio: f64,
}

/// The ladder of a gearbox, from analyses of its gears.
///
/// Steps are taken between neighbours of positive ratio, or, if there are no such gears, of negative ratio.
/// Gears without a ratio are named below.
/// without a ratio are named below.
///
/// # Errors
/// [`Error::NoRatio`] where no gear has a ratio.
pub fn scene(gearbox: &Gearbox, gears: &[Analysis], title: Option<&str>) -> Result<Scene, Error> {
    drawn(gearbox, gears, title, HEIGHTS_MM[0], true)
}

/// Ladder of less height and without title, for a page with a title of its own.
///
/// # Errors
/// Those of [`scene`].
pub fn bare(gearbox: &Gearbox, gears: &[Analysis]) -> Result<Scene, Error> {
    drawn(gearbox, gears, None, HEIGHTS_MM[1], false)
}

fn drawn(
    gearbox: &Gearbox,
    gears: &[Analysis],
    title: Option<&str>,
    height_mm: f64,
    is_headed: bool,
) -> Result<Scene, Error> {
    let mut rungs: Vec<Rung<'_>> = gears
        .iter()
        .filter_map(|gear| Some(Rung { name: gear.gear().name(), ratio: gear.ratio()? }))
        .filter(|rung| rung.ratio != 0.0 && rung.ratio.is_finite())
        .collect();
    rungs.sort_by(|a, b| a.ratio.abs().total_cmp(&b.ratio.abs()));
    let (Some(least), Some(most)) = (rungs.first(), rungs.last()) else {
        return Err(Error::NoRatio { gearbox: gearbox.name().into(), gears: gears.len() });
    };
    let scale = Scale::around(least.ratio.abs(), most.ratio.abs(), height_mm);

    let mut scene = Scene::new(title.map_or_else(|| format!("{}: ratios", gearbox.name()), str::to_owned));
    let axis = scene.layer("scale", Style::line(0.25))?;
    let rails = scene.layer("rungs", Style::line(0.7).color(COLORS[0]))?;
    let steps = scene.layer("steps", Style::line(0.18).color(Color::GREY))?;
    let labels = scene.layer("labels", Style::line(0.1))?;

    scene.add(axis, Shape::line([0.0, 0.0], [0.0, height_mm]));
    for tick in scale.ticks() {
        let y = scale.y(tick);
        scene.add(axis, Shape::line([-1.5, y], [0.0, y]));
        scene.add(labels, Text::new([-2.5, y], LETTERS_MM, short(tick)).align(Align::Right));
    }
    let wanted: Vec<f64> = rungs.iter().map(|rung| scale.y(rung.ratio.abs())).collect();
    let places = spread(&wanted, PITCH_MM);
    let texts: Vec<(Text, Text)> = rungs
        .iter()
        .zip(&places)
        .map(|(rung, &y)| {
            let name = Text::new([48.0, y], LETTERS_MM, rung.name).align(Align::Left);
            (name, Text::new([0.0, y], LETTERS_MM, decimal(rung.ratio)).align(Align::Right))
        })
        .collect();
    let widest =
        |text: fn(&(Text, Text)) -> &Text| texts.iter().map(|both| text(both).width_mm()).fold(0.0, f64::max);
    let ratios_at = 48.0 + widest(|both| &both.0) + 4.0 + widest(|both| &both.1);
    for ((rung, wanted), (name, ratio)) in rungs.iter().zip(&wanted).zip(texts) {
        let style = match rung.ratio < 0.0 {
            true => Style::line(0.7).color(COLORS[1]).dash(Dash::Dashed),
            false => Style::line(0.7).color(COLORS[0]),
        };
        scene.add_styled(rails, style, Shape::line([3.0, *wanted], [36.0, *wanted]));
        scene.add(
            steps,
            Shape::polyline([[36.8, *wanted], [38.5, *wanted], [45.0, name.at.y], [47.0, name.at.y]]),
        );
        let at = [ratios_at, ratio.at.y].into();
        scene.add(labels, name);
        scene.add(labels, Text { at, ..ratio });
    }
    let forward = rungs.iter().any(|rung| rung.ratio > 0.0);
    let mut counted: Vec<usize> = (0..rungs.len()).filter(|&i| (rungs[i].ratio > 0.0) == forward).collect();
    // Gears of one ratio, as first and first low, are one step of the ladder.
    counted.dedup_by(|next, last| (rungs[*next].ratio / rungs[*last].ratio - 1.0).abs() <= SAME_RATIO);
    let bracket = ratios_at + 4.0;
    for pair in counted.windows(2) {
        let [low, high] = [pair[0], pair[1]].map(|i| places[i]);
        let (low, high) = (low + 0.6, high - 0.6);
        let corners = [[bracket - 1.0, low], [bracket, low], [bracket, high], [bracket - 1.0, high]];
        scene.add(steps, Shape::polyline(corners));
        let step = rungs[pair[1]].ratio / rungs[pair[0]].ratio;
        let at = [bracket + 2.0, f64::midpoint(low, high)];
        scene.add(labels, Text::new(at, LETTERS_MM, format!("φ = {}", decimal(step))).align(Align::Left));
    }

    let top = scene.bounds().top.max(height_mm) + 7.0;
    let left = scene.bounds().left;
    if is_headed {
        let heading = Text::new([left, top + 5.0], TITLE_MM, scene.title()).align(Align::Left);
        scene.add(labels, heading);
    }
    scene.add(labels, Text::new([-2.5, top - 1.0], LETTERS_MM, "|i|").align(Align::Right));
    scene.add(labels, Text::new([48.0, top - 1.0], LETTERS_MM, "gear").align(Align::Left));
    scene.add(labels, Text::new([ratios_at, top - 1.0], LETTERS_MM, "i").align(Align::Right));
    let mut y = scene.bounds().bottom - 6.0;
    for words in words(gears, &rungs, &counted) {
        scene.add(labels, Text::new([left, y], LETTERS_MM, words).align(Align::Left));
        y -= 4.6;
    }
    scene.check()?;
    Ok(scene)
}

/// Text below the ladder: the whole range, the gears that reverse, and the gears without a ratio.
fn words(gears: &[Analysis], rungs: &[Rung<'_>], counted: &[usize]) -> Vec<String> {
    let mut words = vec![];
    if let [first, .., last] = counted {
        let range = rungs[*last].ratio / rungs[*first].ratio;
        let mean = libm::pow(range, 1.0 / (counted.len() - 1) as f64);
        words.push(format!(
            "range {} over {} ratios, mean step {}",
            decimal(range),
            counted.len(),
            decimal(mean)
        ));
    }
    if rungs.iter().any(|rung| rung.ratio < 0.0) {
        words.push("dashed: the output turns against the input".into());
    }
    for gear in gears.iter().filter(|gear| !rungs.iter().any(|rung| rung.name == gear.gear().name())) {
        words.push(format!("gear {} has no ratio: {}", gear.gear().name(), gear.state().name()));
    }
    words
}

/// A logarithmic scale between two of the numbers 1, 2, 5 times a power of ten.
struct Scale {
    low: f64,
    high: f64,
    height_mm: f64,
}

impl Scale {
    fn around(least: f64, most: f64, height_mm: f64) -> Self {
        let below = marks(least).into_iter().filter(|mark| *mark <= least * (1.0 + MARK)).fold(0.0, f64::max);
        let above = marks(most).into_iter().filter(|mark| *mark >= most * (1.0 - MARK));
        let above = above.fold(f64::INFINITY, f64::min);
        // A gear of 1 alone still needs a scale.
        if below < above * (1.0 - MARK) {
            Self { low: below, high: above, height_mm }
        } else {
            Self { low: below / 2.0, high: above * 2.0, height_mm }
        }
    }

    fn y(&self, ratio: f64) -> f64 {
        self.height_mm * libm::log(ratio / self.low) / libm::log(self.high / self.low)
    }

    fn ticks(&self) -> Vec<f64> {
        let mut ticks: Vec<f64> = vec![];
        let mut decade = self.low;
        while decade <= self.high * 10.0 {
            ticks.extend(
                marks(decade)
                    .into_iter()
                    .filter(|mark| (self.low * (1.0 - MARK)..=self.high * (1.0 + MARK)).contains(mark)),
            );
            decade *= 10.0;
        }
        ticks.sort_by(f64::total_cmp);
        ticks.dedup_by(|a, b| (*a / *b - 1.0).abs() < MARK);
        let mut kept: Vec<f64> = vec![];
        for tick in ticks {
            if kept.last().is_none_or(|last| self.y(tick) - self.y(*last) > 1.6 * LETTERS_MM) {
                kept.push(tick);
            }
        }
        kept
    }
}

/// 1, 2, 5 of the decade of a number, and the last before and the first after.
fn marks(near: f64) -> [f64; 5] {
    let decade = libm::pow(10_f64, libm::log10(near).floor());
    [0.5, 1.0, 2.0, 5.0, 10.0].map(|part| part * decade)
}

/// A round number as it is.
fn short(tick: f64) -> String {
    let text = format!("{tick:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_drawing::svg;
    use epicyclic_train::set::SetSpec;

    #[test]
    fn gears_of_one_ratio_are_one_step() {
        let gearbox = Gearbox::builder("two first gears")
            .links(["sun", "ring", "out"])
            .set(SetSpec::simple("1", ["sun", "ring", "out"], 3.0))
            .brake("B", "ring")
            .clutch("C", "sun", "out")
            .input("sun")
            .output("out")
            .gear("1", ["B"])
            .gear("1 low", ["B"])
            .gear("2", ["C"])
            .build()
            .unwrap();
        let gears: Vec<Analysis> =
            gearbox.gears().iter().map(|gear| gearbox.analyze_gear(gear).unwrap()).collect();
        let drawn = svg::write(&scene(&gearbox, &gears, None).unwrap()).unwrap();
        assert!(drawn.contains("range 4.000 over 2 ratios, mean step 4.000"), "{drawn}");
        assert_eq!(drawn.matches("φ = ").count(), 1);
    }

    #[test]
    fn the_scale_ends_at_round_numbers() {
        let scale = Scale::around(0.6667, 4.7143, 100.0);
        assert_eq!((scale.low, scale.high), (0.5, 5.0));
        assert_eq!(scale.ticks().iter().map(|tick| short(*tick)).collect::<Vec<_>>(), ["0.5", "1", "2", "5"]);
        // Equal steps are equal distances.
        assert!((scale.y(4.0) - scale.y(2.0) - (scale.y(2.0) - scale.y(1.0))).abs() < MARK);
        let one = Scale::around(1.0, 1.0, 100.0);
        assert!(one.low < 1.0 && one.high > 1.0);
    }
}
