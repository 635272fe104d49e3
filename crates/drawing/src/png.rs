//! The scene as pixels, with the border of the image and its size in millimetres.
//!
//! The image of [`svg`](crate::svg) with text as outlines, on white. The same scene gives the same bytes.

use png::{BitDepth, ColorType, Encoder, PixelDimensions, Unit};
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};

use crate::error::Error;
use crate::scene::Scene;
use crate::svg::{outlined, page};

/// The least and the greatest resolution, in pixels an inch.
pub const DPI: [f64; 2] = [20.0, 2400.0];

/// The most pixels of an image: 400 MB while it is drawn.
pub const MOST_PIXELS: f64 = 1e8;

/// Millimetres to an inch, and pixels of an SVG's own unit to an inch.
const INCH: [f64; 2] = [25.4, 96.0];

/// Pixels across and down.
fn size(scene: &Scene, dpi: f64) -> [f64; 2] {
    let bounds = page(scene);
    [bounds.width(), bounds.height()].map(|mm| (mm / INCH[0] * dpi).ceil())
}

/// The greatest resolution at which an image of the scene has no more than [`MOST_PIXELS`], whole.
#[must_use]
pub fn most_dpi(scene: &Scene) -> f64 {
    let bounds = page(scene);
    let of_area = (MOST_PIXELS / (bounds.width() * bounds.height())).sqrt() * INCH[0];
    let mut dpi = DPI[1].min(of_area.floor());
    // Parts of pixels at the edges count as whole ones.
    while dpi > 1.0 && size(scene, dpi).iter().product::<f64>() > MOST_PIXELS {
        dpi -= 1.0;
    }
    dpi
}

/// The scene as a PNG image of `dpi` pixels an inch.
///
/// # Errors
/// As [`Scene::check`]; [`Error::Resolution`], [`Error::Pixels`], [`Error::TooLarge`].
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // sizes are checked
pub fn write(scene: &Scene, dpi: f64) -> Result<Vec<u8>, Error> {
    let image = outlined(scene)?;
    let [width, height] = size(scene, dpi);
    let most_dpi = most_dpi(scene);
    if most_dpi < DPI[0] {
        let [width, height] = size(scene, DPI[0]);
        return Err(Error::TooLarge { width, height, least_dpi: DPI[0], most: MOST_PIXELS });
    }
    let refused = Error::Pixels { dpi, width, height, most_dpi, most: MOST_PIXELS };
    // The limit told is the one that the next try has to keep.
    if dpi.is_nan() || dpi < DPI[0] {
        return Err(Error::Resolution { dpi, limit: DPI[0], is_below: true });
    }
    if dpi > DPI[1] && most_dpi == DPI[1] {
        return Err(Error::Resolution { dpi, limit: DPI[1], is_below: false });
    }
    if dpi > DPI[1] || width * height > MOST_PIXELS {
        return Err(refused);
    }
    let (Ok(tree), Some(mut drawn)) =
        (Tree::from_str(&image, &Options::default()), Pixmap::new(width as u32, height as u32))
    else {
        return Err(refused);
    };
    drawn.fill(Color::WHITE);
    let scale = (dpi / INCH[1]) as f32;
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut drawn.as_mut());
    // The paper is white and opaque, so the alpha channel is dropped.
    let colors: Vec<u8> = drawn.data().chunks_exact(4).flat_map(|pixel| &pixel[..3]).copied().collect();
    let mut out = vec![];
    let mut encoder = Encoder::new(&mut out, width as u32, height as u32);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    let metre = (dpi / INCH[0] * 1000.0).round() as u32;
    encoder.set_pixel_dims(Some(PixelDimensions { xppu: metre, yppu: metre, unit: Unit::Meter }));
    // Into memory, of the size that was given.
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(&colors)?;
        writer.finish()
    });
    written.map_err(|_| refused)?;
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bounds::Point;
    use crate::label::Text;
    use crate::scene::Shape;
    use crate::style::Style;

    fn scene() -> Scene {
        let mut scene = Scene::new("square");
        let layer = scene.layer("all", Style::filled(crate::Color::new(200, 0, 0))).unwrap();
        scene.add(layer, Shape::rectangle(Point::new(0.0, 0.0), Point::new(42.8, 17.4)));
        scene.add_styled(layer, Style::line(0.1), Text::new([20.0, 8.0], 4.0, "H"));
        scene
    }

    #[test]
    fn an_image_has_the_size_and_the_colours_of_its_scene() {
        let image = write(&scene(), 100.0).unwrap();
        assert_eq!(image, write(&scene(), 100.0).unwrap());
        let decoded = Pixmap::decode_png(&image).unwrap();
        // 50.8 and 25.4 mm with the borders.
        assert_eq!((decoded.width(), decoded.height()), (200, 100));
        let at = |x, y| decoded.pixel(x, y).map(|p| [p.red(), p.green(), p.blue()]).unwrap();
        assert_eq!(at(2, 2), [255; 3]);
        assert_eq!(at(30, 50), [200, 0, 0]);
        let black = decoded.pixels().iter().filter(|p| p.red() == 0 && p.green() == 0).count();
        assert!(black > 30, "{black}");
    }

    #[test]
    fn too_many_pixels_are_refused() {
        for dpi in [f64::NAN, 0.0, 19.9, 2400.1, f64::INFINITY] {
            let Err(Error::Resolution { limit, is_below, .. }) = write(&scene(), dpi) else {
                panic!("{dpi}")
            };
            let allowed = write(&scene(), limit).is_ok();
            assert!(allowed && is_below == (limit == DPI[0]), "{dpi}: {limit}");
        }
        assert_eq!(
            write(&scene(), 19.0).unwrap_err().to_string(),
            "19 pixels an inch; at least 20 are allowed"
        );
        let mut large = scene();
        let layer = large.layer("far", Style::line(0.5)).unwrap();
        large.add(layer, Shape::line([0.0, 0.0], [900.0, 900.0]));
        let Err(Error::Pixels { most_dpi: fits, .. }) = write(&large, 600.0) else { panic!() };
        let pixels = |dpi| size(&large, dpi).iter().product::<f64>();
        assert!(pixels(fits) <= MOST_PIXELS && pixels(fits + 1.0) > MOST_PIXELS, "{fits}");
        let of = |dpi| write(&large, dpi).unwrap_err().to_string();
        for dpi in [600.0, 3000.0] {
            assert!(of(dpi).ends_with(&format!("for this picture at most {fits} an inch")), "{}", of(dpi));
        }
        assert_eq!(of(19.0), "19 pixels an inch; at least 20 are allowed");

        let layer = large.layer("very far", Style::line(0.5)).unwrap();
        large.add(layer, Shape::line([0.0, 0.0], [20_000.0, 20_000.0]));
        for dpi in [10.0, 20.0, 300.0] {
            assert!(matches!(write(&large, dpi), Err(Error::TooLarge { .. })), "{dpi}");
        }
    }
}
