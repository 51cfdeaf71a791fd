//! Whole pictures.

use super::*;
use ferrocut_geometry::{Plane, Position};
use ferrocut_machine::Language;
use ferrocut_toolpath::{Feed, FeedAlong, Op, PathMode};
use proptest::prelude::*;
use std::collections::BTreeSet;
use tiny_skia::Pixmap;

fn rapid(x: f64, y: f64, z: f64) -> Op {
    Op::Rapid { to: Position::xyz(x, y, z), straight: true, speed: None, path: PathMode::ON_PATH }
}

fn feed(x: f64, y: f64, z: f64) -> Op {
    let to = Position::xyz(x, y, z);
    Op::Feed { to, feed: Feed::PerMinute(100.0), path: PathMode::Continuous }
}

fn arc(to: Position, plane: Plane, center: [f64; 2], sweep: f64) -> Op {
    let (feed, feed_along) = (Feed::PerMinute(100.0), FeedAlong::Path);
    Op::Arc { to, plane, center, sweep, feed, feed_along, path: PathMode::Continuous }
}

fn english() -> Catalogue {
    Catalogue::new(Language::En)
}

fn model(ops: &[Op]) -> PathModel {
    let mut model = PathModel::new(Position::ZERO);
    ops.iter().for_each(|op| model.step(op));
    model
}

fn svg(ops: &[Op], title: &str) -> String {
    String::from_utf8(render(&model(ops), title, 800, Picture::Svg, english()).unwrap()).unwrap()
}

/// The colours inside a rectangle of a picture.
fn colours(picture: &Pixmap, area: [u32; 4]) -> BTreeSet<[u8; 3]> {
    let [x0, y0, x1, y1] = area;
    (x0..x1)
        .flat_map(|x| (y0..y1).map(move |y| (x, y)))
        .filter_map(|(x, y)| picture.pixel(x, y))
        .map(|p| [p.red(), p.green(), p.blue()])
        .collect()
}

#[test]
fn a_png_decodes_and_shows_two_depths_in_two_colours() {
    let mut ops = vec![feed(0.0, 0.0, -1.0), feed(100.0, 0.0, -1.0), rapid(0.0, 50.0, 5.0)];
    ops.extend([feed(0.0, 50.0, -9.0), feed(100.0, 50.0, -9.0)]);
    let png = render(&model(&ops), "two.nc", 1600, Picture::Png, english()).unwrap();
    let picture = Pixmap::decode_png(&png).unwrap();
    assert_eq!((picture.width(), picture.height()), (1600, 800));
    // The middle of the top view: lines along X at Y0, below, and at Y50, above.
    let (upper, lower) = (colours(&picture, [360, 160, 380, 420]), colours(&picture, [360, 420, 380, 700]));
    let blue = |c: &[u8; 3]| c[2] > c[0].saturating_add(40) && c[2] > c[1].saturating_add(40);
    let gold = |c: &[u8; 3]| c[0] > c[2].saturating_add(40);
    assert!(upper.iter().any(blue) && !upper.iter().any(gold), "{upper:?}");
    assert!(lower.iter().any(gold) && !lower.iter().any(blue), "{lower:?}");
}

#[test]
fn rapids_are_dashed_and_cuts_are_not() {
    let cuts = svg(&[feed(10.0, 5.0, -1.0)], "a");
    assert!(!cuts.contains("stroke-dasharray"));
    assert!(svg(&[rapid(10.0, 5.0, -1.0)], "a").contains("stroke-dasharray"));
}

#[test]
fn a_path_without_moves_says_so() {
    for ops in [vec![], vec![Op::Coolant(true)], vec![feed(0.0, 0.0, 0.0)]] {
        assert!(!moved(&model(&ops)));
        assert!(!svg(&ops, "none").contains("stroke-dasharray"));
    }
    let mut rotary = Position::ZERO;
    rotary.0[3] = 90.0;
    let turn = Op::Feed { to: rotary, feed: Feed::PerMinute(1.0), path: PathMode::ExactStop };
    assert_ne!(svg(&[turn], "none"), svg(&[], "none"));
}

#[test]
fn holes_are_dots_from_above() {
    let ops = [rapid(0.0, 0.0, 1.0), feed(0.0, 0.0, -5.0), rapid(0.0, 0.0, 1.0), rapid(50.0, 20.0, 1.0)];
    let ops = [&ops[..], &[feed(50.0, 20.0, -5.0), rapid(50.0, 20.0, 1.0)]].concat();
    assert!(svg(&ops, "holes").contains("h0"));
}

#[test]
fn a_far_tool_change_does_not_make_the_part_small() {
    let cuts = [rapid(500.0, 300.0, -100.0), feed(510.0, 300.0, -100.0), feed(510.0, 305.0, -100.0)];
    let model = model(&[&cuts[..], &[rapid(0.0, 0.0, 0.0)]].concat());
    let part = part(&model);
    assert_eq!(part.size(), [10.0, 5.0, 0.0]);
    assert!(shown(&model, &part).longest() < 15.0);
}

/// Checks that tags are closed in order, attributes quoted and path data made of numbers.
fn check_xml(text: &str) {
    let mut open = Vec::new();
    for tag in text.split('<').skip(1) {
        let (tag, after) = tag.split_once('>').expect("a tag ends");
        assert!(!after.contains('>'), "{after}");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name));
            continue;
        }
        assert_eq!(tag.matches('"').count() % 2, 0, "{tag}");
        if let Some((_, data)) = tag.split_once(" d=\"") {
            let data = data.split('"').next().unwrap();
            assert!(data.bytes().all(|b| b.is_ascii_digit() || b" .-Mlhz".contains(&b)), "{data}");
        }
        if !tag.ends_with('/') {
            open.push(tag.split(' ').next().unwrap());
        }
    }
    assert!(open.is_empty(), "{open:?}");
}

#[test]
fn an_svg_is_well_formed() {
    let ops = [rapid(3.0, 4.0, 5.0), feed(30.0, -4.0, -5.0), feed(3.0, 4.0, -5.0)];
    for title in ["part.nc", "<&>\"'\u{0}\u{ffff}", "测试.nc", ""] {
        let text = svg(&ops, title);
        check_xml(&text);
        assert!(text.starts_with("<svg ") && text.contains("width=\"800\" height=\"400\""));
    }
}

/// Coordinates of every size that a program can name, and some that none should. On the heap: what nine of them are made of,
/// in each of many operations, takes more than a thread's stack.
fn coordinate() -> BoxedStrategy<f64> {
    prop_oneof![
        6 => -200.0..200.0f64,
        2 => (-4i32..4).prop_map(f64::from),
        1 => -1e8..1e8f64,
        1 => prop::sample::select(vec![0.0, 1e-300, 1e-9, 1e15, -1e20, f64::MAX, f64::MIN]),
        1 => prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY]),
    ]
    .boxed()
}

fn op() -> impl Strategy<Value = Op> {
    let position = || prop::array::uniform9(coordinate()).prop_map(Position);
    let plane = prop::sample::select(vec![Plane::Xy, Plane::Zx, Plane::Yz]);
    let sweep = prop_oneof![-7.0..7.0f64, -1e6..1e6f64, coordinate()];
    prop_oneof![
        position().prop_map(|to| Op::Rapid { to, straight: false, speed: None, path: PathMode::ON_PATH }),
        position().prop_map(|to| Op::Tap { to, pitch: 1.0, rpm: 100.0, goes_on: false }),
        position().prop_map(|to| Op::Feed { to, feed: Feed::Duration(1.0), path: PathMode::Continuous }),
        (position(), plane, coordinate(), coordinate(), sweep).prop_map(|(to, plane, a, b, sweep)| arc(
            to,
            plane,
            [a, b],
            sweep
        )),
        Just(Op::Change(1)),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]
    #[test]
    fn any_steps_make_a_picture(
        ops in prop::collection::vec(op(), 0..40),
        start in prop::array::uniform9(coordinate()),
        zero in prop::option::of(prop::array::uniform9(coordinate())),
        title in ".{0,40}",
        width in prop::sample::select(vec![400, 800, 1234]),
    ) {
        let mut model = PathModel::new(Position(start));
        if let Some(zero) = zero {
            model.set_work_zero(Position(zero));
        }
        ops.iter().for_each(|op| model.step(op));
        let png = render(&model, &title, width, Picture::Png, english()).unwrap();
        prop_assert!(Pixmap::decode_png(&png).is_ok());
        let svg = String::from_utf8(render(&model, &title, width, Picture::Svg, english()).unwrap()).unwrap();
        check_xml(&svg);
        prop_assert!(svg.len() < 40_000_000, "{} bytes", svg.len());
    }
}

#[test]
fn labels_are_in_the_language_and_those_that_the_font_lacks_are_letters_of_the_viewer() {
    let model = model(&[feed(10.0, 0.0, -1.0), rapid(0.0, 5.0, 2.0)]);
    let svg = |tag: &str| {
        let catalogue = Catalogue::new(Language::from_tag(tag).unwrap());
        String::from_utf8(render(&model, "a.nc", 800, Picture::Svg, catalogue).unwrap()).unwrap()
    };
    let all = ["en", "zh", "ru", "es", "tr"].map(svg);
    assert!(all.iter().enumerate().all(|(n, one)| !all.iter().skip(n + 1).any(|other| one == other)));
    all.iter().for_each(|one| check_xml(one));
    let [first, chinese, rest @ ..] = &all;
    assert!(chinese.contains(">俯视图</text>") && !chinese.contains("label-view"));
    assert!(rest.iter().chain([first]).all(|one| !one.contains("<text")));
    // A picture of pixels has no letters but its own.
    for tag in ["ru", "es", "tr"] {
        let catalogue = Catalogue::new(Language::from_tag(tag).unwrap());
        assert_ne!(Labels::drawn(catalogue).top, Labels::drawn(english()).top, "{tag}");
    }
    let chinese = Catalogue::new(Language::from_tag("zh").unwrap());
    assert_eq!(Labels::drawn(chinese).top, Labels::of(english()).top);
}
