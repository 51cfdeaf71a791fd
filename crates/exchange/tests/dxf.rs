//! What is made of the entities of a DXF drawing, by values worked out by hand.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_exchange::curve::Curve;
use ferrocut_exchange::drawing::{Action, Drawing};
use ferrocut_exchange::{Change, Format, Settings, read};
use ferrocut_geometry::vector::{Point, distance};
use ferrocut_machine::{Alarm, Argument, Fault};
use ferrocut_program::FileId;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A drawing of pairs, `code value` a line.
fn dxf(pairs: &str) -> Vec<u8> {
    let mut text = String::new();
    for line in pairs.lines().map(str::trim).filter(|line| !line.is_empty()) {
        let (code, value) = line.split_once(' ').unwrap_or((line, ""));
        text.push_str(&format!("{code:>3}\r\n{value}\r\n"));
    }
    text.into_bytes()
}

fn entities(pairs: &str) -> String {
    format!("0 SECTION\n2 ENTITIES\n{pairs}\n0 ENDSEC\n0 EOF\n")
}

fn blocks(blocks: &str, model: &str) -> String {
    format!("0 SECTION\n2 BLOCKS\n{blocks}\n0 ENDSEC\n{}", entities(model))
}

fn drawing_of(pairs: &str, settings: &Settings) -> Result<Drawing, Box<Alarm>> {
    read(&dxf(pairs), Format::Dxf, FileId(1), settings)
}

fn drawing(pairs: &str) -> Drawing {
    drawing_of(pairs, &Settings::default()).unwrap_or_else(|alarm| panic!("{alarm:?}"))
}

fn curves(drawing: &Drawing) -> Vec<Curve> {
    let cut = |m: &ferrocut_exchange::drawing::Move| match m.action {
        Action::Cut(curve) => curve,
        other => panic!("{other:?}"),
    };
    drawing.moves.iter().map(cut).collect()
}

fn near(a: Point, b: Point) {
    assert!(distance(a, b) < 1e-9, "{a:?} is not {b:?}");
}

/// From, through the middle, to.
fn runs(curve: &Curve, points: [Point; 3]) {
    for (t, p) in [0.0, 0.5, 1.0].into_iter().zip(points) {
        near(curve.at(t), p);
    }
}

const LINE: &str = "0 LINE\n8 0\n10 1\n20 2\n30 9\n11 4\n21 6\n31 0\n";

#[test]
fn lines_arcs_and_circles() {
    let arc = "0 ARC\n10 0\n20 0\n40 10\n50 350\n51 100\n";
    let circle = "0 CIRCLE\n10 5\n20 5\n40 2.5\n";
    let found = curves(&drawing(&entities(&format!("{LINE}{arc}{circle}"))));
    runs(&found[0], [[1.0, 2.0], [2.5, 4.0], [4.0, 6.0]]);
    let at = |degrees: f64| [10.0 * degrees.to_radians().cos(), 10.0 * degrees.to_radians().sin()];
    runs(&found[1], [at(350.0), at(45.0), at(100.0)]);
    assert_eq!(found[2].bend.unwrap().sweep, TAU);
    near(found[2].bend.unwrap().center, [5.0, 5.0]);
    near(found[2].from, [7.5, 5.0]);
}

#[test]
fn polylines_with_bulges() {
    let light = "0 LWPOLYLINE\n90 3\n70 1\n38 7\n10 0\n20 0\n10 10\n20 0\n42 1\n10 10\n20 10\n";
    let found = curves(&drawing(&entities(light)));
    runs(&found[0], [[0.0, 0.0], [5.0, 0.0], [10.0, 0.0]]);
    runs(&found[1], [[10.0, 0.0], [15.0, 5.0], [10.0, 10.0]]);
    runs(&found[2], [[10.0, 10.0], [5.0, 5.0], [0.0, 0.0]]);
    // The old form; a vertex of the frame (flag 16) is not of the curve.
    let old = "0 POLYLINE\n66 1\n70 0\n0 VERTEX\n10 0\n20 0\n42 -1\n0 VERTEX\n70 16\n10 50\n20 50\n\
        0 VERTEX\n10 4\n20 0\n0 SEQEND\n0 LINE\n10 1\n20 1\n11 2\n21 2\n";
    let found = curves(&drawing(&entities(old)));
    runs(&found[0], [[0.0, 0.0], [2.0, 2.0], [4.0, 0.0]]);
    assert_eq!(found.len(), 2);
    // In space: seen from above, without bulges.
    let space = "0 POLYLINE\n70 9\n0 VERTEX\n10 0\n20 0\n30 5\n42 1\n70 32\n0 VERTEX\n10 4\n20 3\n30 1\n70 32\n0 SEQEND\n";
    let found = curves(&drawing(&entities(space)));
    assert_eq!(found.len(), 2);
    runs(&found[1], [[4.0, 3.0], [2.0, 1.5], [0.0, 0.0]]);
}

#[test]
fn looked_at_from_below_everything_is_mirrored() {
    // Extrusion 0, 0, -1: X of the entity's own system is -X.
    let arc = "0 ARC\n10 10\n20 0\n40 5\n50 0\n51 90\n210 0\n220 0\n230 -1\n";
    let found = curves(&drawing(&entities(arc)));
    near(found[0].from, [-15.0, 0.0]);
    near(found[0].to, [-10.0, 5.0]);
    assert!((found[0].bend.unwrap().sweep + FRAC_PI_2).abs() < 1e-12);
}

#[test]
fn blocks_are_placed_scaled_turned_mirrored_and_in_arrays() {
    // A line from the base point (1, 1) one to the right.
    let block =
        "0 BLOCK\n8 0\n2 Part\n70 0\n10 1\n20 1\n3 Part\n0 LINE\n8 0\n10 1\n20 1\n11 2\n21 1\n0 ENDBLK\n";
    let one = "0 INSERT\n8 cut\n2 PART\n10 10\n20 20\n41 2\n42 3\n50 90\n";
    let found = drawing(&blocks(block, one));
    runs(&curves(&found)[0], [[10.0, 20.0], [10.0, 21.0], [10.0, 22.0]]);
    assert_eq!(&*found.layers[0].name, "cut", "layer 0 of a block is the layer it is inserted on");
    // Two columns 5 apart and two rows 7 apart, turned by 90 degrees and not scaled.
    let array = "0 INSERT\n2 Part\n10 0\n20 0\n41 -1\n50 90\n70 2\n71 2\n44 5\n45 7\n";
    let found: Vec<Point> = curves(&drawing(&blocks(block, array))).iter().map(|c| c.from).collect();
    for (found, expected) in found.iter().zip([[0.0, 0.0], [0.0, 5.0], [-7.0, 0.0], [-7.0, 5.0]]) {
        near(*found, expected);
    }
    near(curves(&drawing(&blocks(block, array)))[0].to, [0.0, -1.0]);
    // A block in a block: moved by (100, 0) and doubled, then turned by 180 degrees.
    let outer = "0 BLOCK\n2 Outer\n10 0\n20 0\n0 INSERT\n8 0\n2 Part\n10 100\n20 0\n41 2\n42 2\n0 ENDBLK\n";
    let nested = "0 INSERT\n8 deep\n2 Outer\n10 0\n20 5\n50 180\n";
    let found = drawing(&blocks(&format!("{outer}{block}"), nested));
    runs(&curves(&found)[0], [[-100.0, 5.0], [-101.0, 5.0], [-102.0, 5.0]]);
    assert_eq!(&*found.layers[0].name, "deep");
}

#[test]
fn a_circle_stretched_by_its_block_is_an_ellipse() {
    let block = "0 BLOCK\n2 C\n10 0\n20 0\n0 CIRCLE\n10 0\n20 0\n40 1\n0 ENDBLK\n";
    let found = curves(&drawing(&blocks(block, "0 INSERT\n2 C\n10 0\n20 0\n41 20\n42 10\n")));
    assert!(found.len() > 4 && found.iter().all(|c| c.bend.is_some()));
    for curve in &found {
        for i in 0..=4 {
            let [x, y] = curve.at(f64::from(i) / 4.0);
            let f = (x / 20.0).hypot(y / 10.0);
            // Close to the ellipse the value of its equation changes by 1/10 a mm at most.
            assert!((f - 1.0).abs() < 0.011 / 10.0, "{x} {y}");
        }
    }
}

#[test]
fn ellipses_and_splines() {
    let ellipse = "0 ELLIPSE\n10 0\n20 0\n11 0\n21 20\n40 0.5\n41 0\n42 3.141592653589793\n";
    let found = curves(&drawing(&entities(ellipse)));
    near(found[0].from, [0.0, 20.0]);
    near(found.last().unwrap().to, [0.0, -20.0]);
    let turned: f64 = found.iter().map(|c| c.bend.unwrap().sweep).sum();
    assert!((turned - PI).abs() < 1e-3, "counter-clockwise: {turned}");
    let spline = "0 SPLINE\n70 8\n71 2\n72 6\n73 3\n40 0\n40 0\n40 0\n40 1\n40 1\n40 1\n\
        10 0\n20 0\n30 0\n10 5\n20 10\n30 0\n10 10\n20 0\n30 0\n";
    let found = curves(&drawing(&entities(spline)));
    near(found[0].from, [0.0, 0.0]);
    near(found.last().unwrap().to, [10.0, 0.0]);
    let top = found.iter().map(|c| c.extent()[1][1]).fold(0.0, f64::max);
    assert!((top - 5.0).abs() < 0.01, "{top}");
    // A flat drawing may leave heights out.
    let flat: Vec<&str> = spline.split("30 0\n").collect();
    assert_eq!(curves(&drawing(&entities(&flat.concat()))).len(), found.len());
    near(curves(&drawing(&entities(&flat.concat()))).last().unwrap().to, [10.0, 0.0]);
    // By fit points alone.
    let fit = "0 SPLINE\n70 8\n71 3\n74 3\n11 0\n21 0\n31 0\n11 5\n21 5\n31 0\n11 10\n21 0\n31 0\n";
    let found = curves(&drawing(&entities(fit)));
    near(found.last().unwrap().to, [10.0, 0.0]);
    assert!(found.iter().any(|c| distance(c.at(0.5), [5.0, 5.0]) < 1.0));
    // The same closed.
    let found = curves(&drawing(&entities(&fit.replacen("70 8", "70 9", 1))));
    near(found.last().unwrap().to, found.first().unwrap().from);
    assert!(found.iter().any(|c| c.at(0.5)[1] < -0.5));
}

#[test]
fn units_and_scale() {
    let head = |unit: i32| format!("0 SECTION\n2 HEADER\n9 $INSUNITS\n70 {unit}\n0 ENDSEC\n");
    let to = |text: &str, settings: &Settings| curves(&drawing_of(text, settings).unwrap())[0].to;
    let plain = Settings::default();
    near(to(&(head(1) + &entities(LINE)), &plain), [4.0 * 25.4, 6.0 * 25.4]);
    near(to(&(head(4) + &entities(LINE)), &plain), [4.0, 6.0]);
    near(to(&(head(5) + &entities(LINE)), &plain), [40.0, 60.0]);
    near(to(&(head(0) + &entities(LINE)), &plain), [4.0, 6.0]);
    near(to(&entities(LINE), &plain), [4.0, 6.0]);
    let other = Settings { unit: Some(10.0), scale: 0.5, ..plain };
    near(to(&(head(1) + &entities(LINE)), &other), [20.0, 30.0]);
}

#[test]
fn layers_that_are_not_shown_are_left_out() {
    let tables = "0 SECTION\n2 TABLES\n0 TABLE\n2 LAYER\n70 3\n0 LAYER\n2 Cold\n70 1\n62 7\n0 LAYER\n2 off\n\
        70 0\n62 -7\n0 LAYER\n2 seen\n70 4\n62 1\n0 ENDTAB\n0 ENDSEC\n";
    let on = |layer: &str| LINE.replace("8 0", &format!("8 {layer}"));
    let model = format!("{}{}{}{}", on("COLD"), on("Seen"), on("Off"), on("OFF"));
    let found = drawing(&format!("{tables}{}", entities(&model)));
    assert_eq!(found.moves.len(), 1);
    let left: Vec<_> = found.warnings.iter().map(|w| (w.fault, w.arguments.to_vec())).collect();
    let row = |name: &str, count: f64| {
        (Fault::LayerLeftOut, vec![("name", Argument::from(name)), ("count", Argument::from(count))])
    };
    assert_eq!(left, [row("Cold", 1.0), row("off", 2.0)]);
}

#[test]
fn what_is_not_cut_is_told_by_kind() {
    let others = "0 TEXT\n8 0\n1 words\n0 HATCH\n8 0\n0 TEXT\n8 0\n0 VIEWPORT\n67 1\n0 LINE\n67 1\n10 0\n\
        20 0\n11 1\n21 1\n0 LINE\n60 1\n10 0\n20 0\n11 1\n21 1\n0 POLYLINE\n70 64\n0 VERTEX\n10 1\n20 1\n0 SEQEND\n";
    let found = drawing(&entities(&format!("{LINE}{others}")));
    assert_eq!(found.moves.len(), 1);
    let told: Vec<_> = found.warnings.iter().map(|w| (w.fault, w.span.line, w.arguments.to_vec())).collect();
    let kind =
        |name: &str, count: f64| vec![("kind", Argument::from(name)), ("count", Argument::from(count))];
    let line = |n: u32| 4 + LINE.lines().count() as u32 * 2 + n;
    assert_eq!(
        told,
        [
            (Fault::EntityLeftOut, line(2), kind("TEXT", 2.0)),
            (Fault::EntityLeftOut, line(8), kind("HATCH", 1.0)),
            (Fault::HiddenLeftOut, line(20), vec![("count", Argument::from(2.0))]),
            (Fault::EntityLeftOut, line(44), kind("POLYLINE (mesh)", 1.0)),
        ]
    );
}

#[test]
fn layers_are_named_in_the_drawings_encoding_and_may_be_skipped() {
    let mut bytes = dxf(
        "0 SECTION\n2 HEADER\n9 $DWGCODEPAGE\n3 ANSI_936\n0 ENDSEC\n0 SECTION\n2 ENTITIES\n0 LINE\n8 @\n10 0\n20 0\n11 1\n21 0",
    );
    let at = bytes.iter().position(|b| *b == b'@').unwrap();
    bytes.splice(at..=at, [0xB2, 0xE3]);
    bytes.extend(dxf("0 LINE\n8 Text\n10 0\n20 0\n11 2\n21 0\n0 ENDSEC\n0 EOF"));
    let layers = vec![("TEXT".into(), Change { skip: true, ..Change::default() })];
    let found = read(&bytes, Format::Dxf, FileId(1), &Settings { layers, ..Settings::default() }).unwrap();
    assert_eq!((&*found.layers[0].name, found.moves.len()), ("层", 1));
}

#[test]
fn each_move_knows_the_line_of_its_entity() {
    let found = drawing(&entities(&format!("{LINE}{LINE}")));
    let lines: Vec<u32> = found.moves.iter().map(|m| m.span.line).collect();
    assert_eq!(lines, [6, 22]);
}

fn fault(pairs: &str) -> (Fault, u32) {
    let alarm = drawing_of(pairs, &Settings::default()).unwrap_err();
    (alarm.fault, alarm.span.line)
}

#[test]
fn broken_drawings_end_in_one_alarm_at_its_place() {
    assert_eq!(fault("0 SECTION\n2 ENTITIES\n0 LINE\n10 1"), (Fault::DrawingTruncated, 9));
    assert_eq!(fault("0 SECTION\n2 ENTITIES\n0 EOF"), (Fault::DrawingTruncated, 6));
    assert_eq!(fault("x SECTION"), (Fault::DxfGroupCode, 1));
    assert_eq!(fault(&entities("0 LINE\n10 abc")), (Fault::DxfValue, 8));
    assert_eq!(fault(&entities("0 CIRCLE\n10 1e999")), (Fault::DxfValue, 8));
    assert_eq!(fault(&entities("0 INSERT\n2 A\n70 99999")), (Fault::DxfValue, 10));
    assert_eq!(fault(&entities("0 CIRCLE\n10 9e9\n20 0\n40 1")), (Fault::DrawingTooFar, 6));
    assert_eq!(fault(&entities("0 SPLINE\n71 3\n10 0\n20 0")), (Fault::SplineForm, 6));
    assert_eq!(fault(&entities("0 TEXT\n8 0")), (Fault::DrawingEmpty, 1));
    let own = "0 BLOCK\n2 A\n0 INSERT\n2 b\n0 ENDBLK\n0 BLOCK\n2 B\n0 INSERT\n2 a\n0 ENDBLK\n";
    assert_eq!(fault(&blocks(own, "0 INSERT\n2 A\n")).0, Fault::BlockInItself);
    assert_eq!(
        drawing(&entities(&format!("{LINE}0 INSERT\n2 none\n"))).warnings[0].fault,
        Fault::BlockMissing
    );
    let bytes = read(b"AutoCAD Binary DXF\r\n\x1a\0", Format::Dxf, FileId(1), &Settings::default());
    assert_eq!(bytes.unwrap_err().fault, Fault::DxfBinary);
}

#[test]
fn counts_are_held_to_what_memory_bears() {
    // Nine blocks of a hundred of the next: a million million million lines.
    let mut all = String::from("0 BLOCK\n2 B9\n0 LINE\n10 0\n20 0\n11 1\n21 0\n0 ENDBLK\n");
    for i in 0..9 {
        all.push_str(&format!(
            "0 BLOCK\n2 B{i}\n0 INSERT\n2 B{}\n70 10\n71 10\n44 1\n45 1\n0 ENDBLK\n",
            i + 1
        ));
    }
    assert_eq!(fault(&blocks(&all, "0 INSERT\n2 B0\n")).0, Fault::DrawingTooLarge);
    // The same of nothing at all.
    let empty = all.replace("0 LINE\n10 0\n20 0\n11 1\n21 0\n", "");
    assert_eq!(fault(&blocks(&empty, "0 INSERT\n2 B0\n")).0, Fault::DrawingTooLarge);
    // An ellipse as large as a street with a tolerance of a micrometre is divided all the same.
    let street = entities("0 ELLIPSE\n10 0\n20 0\n11 90000\n21 0\n40 0.5\n41 0\n42 6.283185307179586\n");
    let fine = Settings { tolerance: 0.001, ..Settings::default() };
    assert!(drawing_of(&street, &fine).is_ok());
}

/// Arcs whose centre is too far away for a word become chords; with those of the fit they keep to the
/// tolerance too.
#[test]
fn very_flat_curves_keep_to_the_tolerance() {
    let ellipse = "0 ELLIPSE\n10 0\n20 0\n11 9000\n21 0\n40 0.1\n41 1\n42 2\n";
    let found = curves(&drawing(&entities(ellipse)));
    assert!(found.iter().any(|c| c.bend.is_none()), "radii up to 90 m");
    for curve in &found {
        for i in 0..=8 {
            let [x, y] = curve.at(f64::from(i) / 8.0);
            // Along Y, which is all but square to this flat part of the ellipse.
            let off = y - 900.0 * (1.0 - (x / 9000.0).powi(2)).sqrt();
            assert!(off.abs() < 0.0102, "{off} at {x}");
        }
    }
}

/// A line with a hundredth of a millimetre of sag: the centre of its arc is 125 m away and is never written.
#[test]
fn an_arc_may_be_shallow() {
    let shallow = drawing(&entities("0 LWPOLYLINE\n8 0\n90 2\n70 0\n10 0\n20 0\n42 0.0002\n10 100\n20 0\n"));
    let chords = curves(&shallow);
    assert!(chords.iter().all(|chord| chord.bend.is_none()), "{chords:?}");
    let deepest = chords.iter().map(|chord| chord.to[1]).fold(0.0, f64::min);
    assert!((-0.011..-0.005).contains(&deepest), "{deepest}");
    near(chords.last().unwrap().to, [100.0, 0.0]);
    // What is cut of it has to be within reach.
    let far = drawing_of(&entities("0 CIRCLE\n8 0\n10 0\n20 -200000\n40 200000\n"), &Settings::default());
    assert_eq!(far.unwrap_err().fault, Fault::DrawingTooFar);
}

#[test]
fn a_spline_may_have_more_knots_than_16_bits_count() {
    const POINTS: usize = 40_000;
    let mut text = format!("0 SPLINE\n8 0\n70 8\n71 1\n72 {}\n73 {POINTS}\n74 0\n40 0\n", POINTS + 2);
    for k in 0..POINTS {
        text.push_str(&format!("40 {k}\n"));
    }
    text.push_str(&format!("40 {}\n", POINTS - 1));
    for k in 0..POINTS {
        text.push_str(&format!("10 {}\n20 {}\n30 0\n", k as f64 * 0.01, k % 2));
    }
    let drawing = drawing(&entities(&text));
    near(curves(&drawing).last().unwrap().to, [(POINTS - 1) as f64 * 0.01, 1.0]);
}
