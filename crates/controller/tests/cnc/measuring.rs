//! Work zeros and tools measured by skip signal and by hand, on a simulated machine with blocks that the probe touches

//! (GSK990MC part 2, 3.4.3). The plant's probe is a point: walls stand half a ball before those of the part.

use crate::common::shop::{Shop, person};
use ferrocut_controller::api::{Activity, Command, Event, Measurement, Reply};
use ferrocut_controller::drives::{Block, Plant};
use ferrocut_controller::{Mode, Parts};
use ferrocut_geometry::Position;
use ferrocut_machine::Machine;
use serde_json::{Value, json};

/// Diameter of the probe's ball, mm.
const BALL: f64 = 2.0;

fn machine() -> Machine {
    let mut machine = Machine::demo_mill();
    machine.homing.absolute = true;
    machine.spindle.acceleration_rpm_s = 40_000.0;
    for (name, value) in [("P391", BALL), ("NO4.0", 1.0), ("NO40.7", 0.0)] {
        machine.parameters.insert(name.to_owned(), value);
    }
    machine
}

/// A control that knows its axes, among blocks, the probe at this place, in AUTO.
fn among(blocks: &[Block], at: [f64; 3]) -> Shop {
    among_of(&machine(), blocks, at)
}

fn among_of(machine: &Machine, blocks: &[Block], at: [f64; 3]) -> Shop {
    let mut plant = Plant::new(machine, Position::ZERO, Position::ZERO);
    blocks.iter().for_each(|block| plant.place(*block));
    let parts = Parts { drives: Some(Box::new(plant)), ..Parts::default() };
    let mut shop = Shop::of(machine, parts);
    shop.mode(Mode::Mdi);
    shop.say(Command::Mdi { text: format!("G54 G90 G0 Z{}\nX{} Y{}", at[2], at[0], at[1]) });
    shop.start();
    shop.until_it_stops();
    shop.mode(Mode::Auto);
    shop.events.clear();
    shop
}

fn block(min: [f64; 3], max: [f64; 3]) -> Block {
    Block { min, max }
}

/// Walls around a room, from -100 up to 0.
fn room(x: [f64; 2], y: [f64; 2]) -> Vec<Block> {
    vec![
        block([x[1], -200.0, -100.0], [200.0, 200.0, 0.0]),
        block([-200.0, -200.0, -100.0], [x[0], 200.0, 0.0]),
        block([-200.0, y[1], -100.0], [200.0, 200.0, 0.0]),
        block([-200.0, -200.0, -100.0], [200.0, y[0], 0.0]),
    ]
}

fn command(mut what: Value, name: &str) -> Command {
    what["do"] = json!(name);
    serde_json::from_value(what).unwrap()
}

/// Prepares, sees that nothing moves, and lets cycle start do it.
fn measure(shop: &mut Shop, command: Command) -> Result<Measurement, String> {
    if let Err(refusal) = shop.control.command(command, &person()) {
        return Err(refusal.alarm.id);
    }
    let before = shop.wait(200);
    assert!(before.measure_ready && before.activity == Activity::Idle);
    shop.start();
    let after = shop.until_it_stops();
    // What is stored within the period comes a moment later.
    shop.wait(20);
    assert!(!after.measure_ready);
    let events = std::mem::take(&mut shop.events);
    let found = events.iter().find_map(|event| match event {
        Event::Measured { measured } => Some(Ok(measured.clone())),
        Event::Alarm { alarm } | Event::Refused { alarm } => Some(Err(alarm.id.clone())),
        _ => None,
    });
    found.unwrap_or_else(|| panic!("{after:?}\n{events:?}"))
}

fn zero(shop: &mut Shop, system: &str) -> [f64; 3] {
    let Reply::Zeros { zeros } = shop.say(Command::Zeros) else { panic!() };
    ['X', 'Y', 'Z'].map(|axis| zeros[system][&axis])
}

#[track_caller]
fn near(a: f64, b: f64) {
    assert!((a - b).abs() < 5e-4, "{a} is not {b}");
}

/// Where rays through `at` along X and Y meet a circle about `centre`.
fn walls(centre: [f64; 2], radius: f64, at: [f64; 2]) -> ([f64; 2], [f64; 2]) {
    let half = |beside: f64| (radius * radius - beside * beside).sqrt();
    let (x, y) = (half(at[1] - centre[1]), half(at[0] - centre[0]));
    ([centre[0] - x, centre[0] + x], [centre[1] - y, centre[1] + y])
}

#[test]
fn a_hole_gives_its_centre_from_a_place_beside_it() {
    let (centre, at) = ([12.3, -7.8], [12.0, -7.5]);
    let (x, y) = walls(centre, 20.0 - BALL / 2.0, at);
    let mut shop = among(&room(x, y), [at[0], at[1], 10.0]);
    let found = measure(
        &mut shop,
        command(json!({"form": "hole", "diameter": 40, "z": -3, "system": "G55"}), "measure"),
    );
    let found = found.unwrap();
    near(found.place[&'X'], centre[0]);
    near(found.place[&'Y'], centre[1]);
    near(found.sizes[0], 40.0);
    assert!(found.out_of_round < 1e-3 && found.stored == ["G55"], "{found:?}");
    let zero = zero(&mut shop, "G55");
    near(zero[0], centre[0]);
    near(zero[1], centre[1]);
    assert_eq!(zero[2], 0.0);
    // The probe is where it began, in the middle of the room.
    let machine = shop.wait(1).position.machine;
    assert_eq!([machine[&'X'], machine[&'Y'], machine[&'Z']], [at[0], at[1], 10.0]);
    // No part was made, and a program runs after it as ever.
    assert_eq!(shop.wait(1).counters.parts, 0);
    shop.store("O0001", "G55 G90 G0 X0 Y0\nM30\n");
    shop.select("O1");
    shop.start();
    let machine = shop.until_it_stops().position.machine;
    near(machine[&'X'], centre[0]);
}

#[test]
fn a_boss_is_passed_over_and_touched_from_outside() {
    let (centre, at) = ([-4.0, 6.0], [-4.2, 6.3]);
    let (x, y) = walls(centre, 15.0 + BALL / 2.0, at);
    let boss = block([x[0], y[0], -100.0], [x[1], y[1], 0.0]);
    let mut shop = among(&[boss], [at[0], at[1], 5.0]);
    // The zero gets other coordinates than 0, beside an external shift.
    shop.say(Command::SetZero { system: "external".into(), axes: [('X', 1.5)].into(), add: false });
    let asked = json!({"form": "boss", "diameter": 30, "z": -4, "system": "G54 P3", "values": {"X": 100.0}});
    let found = measure(&mut shop, command(asked, "measure")).unwrap();
    near(found.sizes[0], 30.0);
    // -1.5 of the external shift moved the probe's place too: the centre is a machine position.
    near(found.place[&'X'], centre[0]);
    let zero = zero(&mut shop, "G54 P3");
    near(zero[0], centre[0] - 1.5 - 100.0);
    near(zero[1], centre[1]);
    // Without a depth it would run into it.
    let flat = json!({"form": "boss", "diameter": 30});
    assert_eq!(measure(&mut shop, command(flat, "measure")).unwrap_err(), "FC-1476");
}

#[test]
fn slots_webs_and_edges_set_the_axes_that_were_measured() {
    let mut shop = among(&room([-21.0, 29.0], [-200.0, 200.0]), [3.0, 0.0, 10.0]);
    let asked = json!({"form": "slot", "lx": 52.0, "z": -5, "system": "G54"});
    let found = measure(&mut shop, command(asked, "measure")).unwrap();
    assert_eq!(found.place.keys().collect::<Vec<_>>(), [&'X']);
    near(found.sizes[0], 52.0);
    near(zero(&mut shop, "G54")[0], 4.0);

    let mut shop = among(&[block([-50.0, -11.0, -100.0], [50.0, 19.0, 0.0])], [0.0, 3.0, 5.0]);
    let asked = json!({"form": "web", "ly": 28.0, "z": -5, "system": "G56"});
    let found = measure(&mut shop, command(asked, "measure")).unwrap();
    near(found.sizes[0], 28.0);
    let set = zero(&mut shop, "G56");
    near(set[1], 4.0);
    assert_eq!(set[0], 0.0);

    // Edges: X in its negative direction, half a ball on; Z with the length of the probe.
    let mut shop = among(&[block([-100.0, -100.0, -100.0], [-15.0, 100.0, 20.0])], [0.0, 0.0, 10.0]);
    let asked = json!({"form": "edge", "axis": "X", "distance": 30, "system": "G54", "values": {"X": 2.0}});
    let found = measure(&mut shop, command(asked, "measure")).unwrap();
    near(found.place[&'X'], -16.0);
    near(zero(&mut shop, "G54")[0], -18.0);
    let mut shop = among(&[block([-100.0, -100.0, -100.0], [100.0, 100.0, -20.0])], [0.0, 0.0, 0.0]);
    let values = json!({"do": "set_offset", "number": 7, "length": 50.0, "length_wear": 0.25});
    shop.say(serde_json::from_value(values).unwrap());
    let asked = json!({"form": "edge", "axis": "Z", "distance": 40, "system": "G54", "h": 7});
    measure(&mut shop, command(asked, "measure")).unwrap();
    near(zero(&mut shop, "G54")[2], -70.25);
    // Where they lie is passed to at the height of the probe, over a wall that is lower; it goes down there.
    let wall = block([-40.0, -100.0, -100.0], [40.0, 20.0, 5.0]);
    let step = block([-100.0, -100.0, -100.0], [100.0, 100.0, -20.0]);
    let mut shop = among(&[wall, step], [0.0, 0.0, 10.0]);
    let asked = json!({"form": "edge", "axis": "Y", "positive": false, "distance": 30,
                       "x": 10, "y": 45, "z": -5, "system": "G54"});
    let found = measure(&mut shop, command(asked, "measure")).unwrap();
    near(found.place[&'Y'], 19.0);
    let at = shop.control.status().position.machine;
    for (axis, there) in [('X', 10.0), ('Y', 45.0), ('Z', 10.0)] {
        near(at[&axis], there);
    }
    let mut shop = among(&[wall, step], [0.0, 0.0, 10.0]);
    let asked = json!({"form": "edge", "axis": "Z", "distance": 40, "x": -60, "y": 30, "system": "G54"});
    let found = measure(&mut shop, command(asked, "measure")).unwrap();
    near(found.place[&'Z'], -20.0);
}

/// Where the ray from a place inside a circle meets it, and the cosine of the ray's angle.
fn on_circle(at: [f64; 2], angle: f64, centre: [f64; 2], radius: f64) -> ([f64; 2], f64) {
    let (sin, cos) = angle.to_radians().sin_cos();
    let away = [at[0] - centre[0], at[1] - centre[1]];
    let along = away[0] * cos + away[1] * sin;
    let far = -along + (along * along + radius * radius - away[0] * away[0] - away[1] * away[1]).sqrt();
    ([at[0] + far * cos, at[1] + far * sin], cos)
}

#[test]
fn forms_that_lie_at_an_angle() {
    // A web at 30°: walls across the direction, met on the line through the place.
    let (sin, cos) = 30f64.to_radians().sin_cos();
    let (at, offset, half) = ([5.0, -3.0], 0.4, 12.0 + BALL / 2.0);
    let on = |distance: f64| [at[0] + distance * cos, at[1] + distance * sin];
    let (right, left) = (on(offset + half), on(offset - half));
    let web = block([left[0], -80.0, -100.0], [right[0], 80.0, 0.0]);
    let mut shop = among(&[web], [at[0], at[1], 5.0]);
    let asked = json!({"form": "vector_web", "width": 24, "angle": 30, "z": -3, "system": "G57"});
    let found = measure(&mut shop, command(asked, "measure")).unwrap();
    near(found.sizes[0], 24.0);
    let centre = on(offset);
    let set = zero(&mut shop, "G57");
    near(set[0], centre[0]);
    near(set[1], centre[1]);

    // A hole of which three parts are left.
    let (centre, radius, angles) = ([8.0, 2.0], 25.0 - BALL / 2.0, [10.0, 130.0, 250.0]);
    let at = [8.3, 1.8];
    let mut blocks = Vec::new();
    for angle in angles {
        let (hit, cos) = on_circle(at, angle, centre, radius);
        // A wall across X whose face stands where the ray meets the circle.
        let (min, max) = if cos > 0.0 { (hit[0], hit[0] + 30.0) } else { (hit[0] - 30.0, hit[0]) };
        blocks.push(block([min, hit[1] - 4.0, -100.0], [max, hit[1] + 4.0, 0.0]));
    }
    let mut shop = among(&blocks, [at[0], at[1], 5.0]);
    let asked = json!({"form": "vector_hole", "diameter": 50, "angles": angles, "z": -3, "system": "G58"});
    let found = measure(&mut shop, command(asked, "measure")).unwrap();
    near(found.sizes[0], 50.0);
    let set = zero(&mut shop, "G58");
    near(set[0], centre[0]);
    near(set[1], centre[1]);

    // A boss, by three blocks whose faces stand where the rays leave it.
    let radius = 25.0 + BALL / 2.0;
    let mut blocks = Vec::new();
    for angle in angles {
        let (hit, cos) = on_circle(at, angle, centre, radius);
        let (min, max) = if cos > 0.0 { (hit[0] - 8.0, hit[0]) } else { (hit[0], hit[0] + 8.0) };
        blocks.push(block([min, hit[1] - 4.0, -100.0], [max, hit[1] + 4.0, 0.0]));
    }
    let mut shop = among(&blocks, [at[0], at[1], 5.0]);
    let asked = json!({"form": "vector_boss", "diameter": 50, "angles": angles, "z": -3, "system": "G59"});
    let found = measure(&mut shop, command(asked, "measure")).unwrap();
    near(found.sizes[0], 50.0);
    let set = zero(&mut shop, "G59");
    near(set[0], centre[0]);
    near(set[1], centre[1]);

    // A slot at 30°, with walls across X where the line through the place meets it.
    let (sin, cos) = 30f64.to_radians().sin_cos();
    let (at, offset, half) = ([5.0, -3.0], -0.3, 20.0 - BALL / 2.0);
    let on = |distance: f64| [at[0] + distance * cos, at[1] + distance * sin];
    let (right, left) = (on(offset + half), on(offset - half));
    let walls = [
        block([right[0], -80.0, -100.0], [right[0] + 20.0, 80.0, 0.0]),
        block([left[0] - 20.0, -80.0, -100.0], [left[0], 80.0, 0.0]),
    ];
    let mut shop = among(&walls, [at[0], at[1], 5.0]);
    let asked = json!({"form": "vector_slot", "width": 40, "angle": 30, "z": -3, "system": "G54 P2"});
    let found = measure(&mut shop, command(asked, "measure")).unwrap();
    near(found.sizes[0], 40.0);
    let set = zero(&mut shop, "G54 P2");
    near(set[0], on(offset)[0]);
    near(set[1], on(offset)[1]);
    // An axis across the direction is not measured, and keeps what it had.
    let walls =
        [block([-80.0, 20.0, -100.0], [80.0, 40.0, 0.0]), block([-80.0, -50.0, -100.0], [80.0, -20.0, 0.0])];
    let mut shop = among(&walls, [14.0, 2.0, 5.0]);
    let before = zero(&mut shop, "G58");
    let asked = json!({"form": "vector_slot", "width": 40, "angle": 90, "z": -3, "system": "G58"});
    let found = measure(&mut shop, command(asked, "measure")).unwrap();
    assert_eq!(found.place.keys().collect::<Vec<_>>(), [&'Y']);
    let set = zero(&mut shop, "G58");
    near(set[1], 0.0);
    assert_eq!(set[0], before[0]);
    // Angles too close to each other (3.4.3.1, D).
    let close = json!({"form": "vector_hole", "diameter": 50, "angles": [10, 14, 250], "z": -3});
    assert_eq!(measure(&mut shop, command(close, "measure")).unwrap_err(), "FC-1476");
}

#[test]
fn what_goes_wrong_stores_nothing() {
    let hole = || {
        command(
            json!({"form": "hole", "diameter": 40, "z": -3, "system": "G55", "tolerance": 0.1}),
            "measure",
        )
    };
    // A hole that is far larger: it is missed.
    let mut shop = among(&room([-60.0, 60.0], [-60.0, 60.0]), [0.0, 0.0, 10.0]);
    assert_eq!(measure(&mut shop, hole()).unwrap_err(), "FC-1472");
    assert_eq!(zero(&mut shop, "G55"), [0.0; 3]);
    shop.start();
    assert_eq!(shop.wait(50).activity, Activity::Alarm, "no start before reset");
    shop.say(Command::Reset);
    assert_eq!(shop.wait(20).activity, Activity::Idle);
    // A size beside its tolerance.
    let mut shop = among(&room([-19.2, 19.2], [-19.2, 19.2]), [0.0, 0.0, 10.0]);
    assert_eq!(measure(&mut shop, hole()).unwrap_err(), "FC-1475");
    assert_eq!(zero(&mut shop, "G55"), [0.0; 3]);
    // Something stands where the probe goes down.
    let mut blocks = room([-19.0, 19.0], [-19.0, 19.0]);
    blocks.push(block([-1.0, -1.0, -100.0], [1.0, 1.0, 2.0]));
    let mut shop = among(&blocks, [0.0, 0.0, 10.0]);
    assert_eq!(measure(&mut shop, hole()).unwrap_err(), "FC-1471");
    let z = shop.wait(1).position.machine[&'Z'];
    assert!(z > 0.5 && z < 2.0, "it stopped on the thing: {z}");
    // A way that leaves the machine.
    let mut shop = among(&[], [0.0, 0.0, 10.0]);
    let far = json!({"form": "edge", "axis": "X", "distance": 1e6});
    assert!(measure(&mut shop, command(far, "measure")).is_err());
}

#[test]
fn hold_holds_and_reset_gives_up() {
    let mut shop = among(&room([-19.0, 19.0], [-19.0, 19.0]), [0.0, 0.0, 10.0]);
    let hole = || command(json!({"form": "hole", "diameter": 40, "z": -3, "system": "G55"}), "measure");
    shop.say(hole());
    shop.start();
    shop.wait(3000);
    shop.hold();
    let held = shop.wait(500);
    assert_eq!((held.activity, held.feed.actual), (Activity::Held, 0.0));
    assert_eq!(shop.wait(200).position.machine, held.position.machine);
    shop.start();
    let status = shop.until_it_stops();
    assert_eq!(status.activity, Activity::Idle);
    let Reply::Measured { measured, .. } = shop.say(Command::Measured) else { panic!() };
    near(measured.unwrap().sizes[0], 40.0);
    shop.say(hole());
    shop.start();
    shop.wait(4000);
    shop.say(Command::Reset);
    shop.wait(300);
    let stands = shop.wait(1);
    assert_eq!(stands.activity, Activity::Idle);
    shop.start();
    assert!(shop.told().contains(&"FC-1403".to_owned()), "there is nothing to start");
    // The interpreter knows where the probe stands.
    shop.mode(Mode::Mdi);
    shop.say(Command::Mdi { text: "G91 G0 Z5".into() });
    shop.start();
    let moved = shop.until_it_stops();
    for axis in ['X', 'Y'] {
        assert_eq!(moved.position.machine[&axis], stands.position.machine[&axis]);
    }
    near(moved.position.machine[&'Z'], stands.position.machine[&'Z'] + 5.0);
}

#[test]
fn what_forbids_measuring() {
    let hole = || command(json!({"form": "hole", "diameter": 40, "z": -3}), "measure");
    let mut shop = among(&[], [0.0, 0.0, 10.0]);
    shop.mode(Mode::Jog);
    assert_eq!(shop.refused(hole()), "FC-1400");
    shop.mode(Mode::Auto);
    shop.inputs.dry_run = true;
    shop.wait(2);
    assert_eq!(shop.refused(hole()), "FC-1477");
    shop.inputs.dry_run = false;
    shop.wait(2);
    // The spindle turns.
    shop.mode(Mode::Mdi);
    shop.say(Command::Mdi { text: "M3 S100".into() });
    shop.start();
    shop.until_it_stops();
    shop.mode(Mode::Auto);
    assert_eq!(shop.refused(hole()), "FC-1477");
    shop.say(Command::Reset);
    shop.wait(20);
    for bad in [
        json!({"form": "hole", "diameter": 0}),
        json!({"form": "hole", "diameter": 1.5}),
        json!({"form": "slot"}),
        json!({"form": "slot", "lx": -5}),
        json!({"form": "hole", "diameter": 40, "probe": 0}),
        json!({"form": "hole", "diameter": 40, "pace": {"search": 0}}),
        json!({"form": "edge", "axis": "Z", "positive": true, "distance": 5}),
        json!({"form": "edge", "axis": "A", "distance": 5}),
        json!({"form": "hole", "diameter": 40, "tolerance": -1}),
    ] {
        assert_eq!(shop.refused(command(bad.clone(), "measure")), "FC-1476", "{bad}");
    }
    let unknown = json!({"form": "hole", "diameter": 40, "system": "G99"});
    assert_eq!(shop.refused(command(unknown, "measure")), "FC-1407");
    // No probe: ideal drives. No reference points: the plant of a machine with incremental encoders.
    let mut ideal = Shop::new(&[]);
    ideal.mode(Mode::Auto);
    assert_eq!(ideal.refused(hole()), "gsk990mc:0282");
    let mut machine = machine();
    machine.homing.absolute = false;
    machine.plant = Some(Default::default());
    machine.parameters.insert("NO4.0".to_owned(), 0.0);
    let mut lost = Shop::of(&machine, Parts::default());
    lost.mode(Mode::Auto);
    assert_eq!(lost.refused(hole()), "gsk990mc:0280");
}

#[test]
fn a_tool_is_measured_on_the_setter_and_the_setter_by_a_known_tool() {
    // Setter: middle at X 60, Y -40, a tool of no length touches it at -180. Stylus 6, tool 82.5 long, 10 thick.
    let (setter, stylus, length, diameter) = ([60.0, -40.0, -180.0], 6.0, 82.5, 10.0);
    let reach = (stylus + diameter) / 2.0;
    let top = setter[2] + length;
    let body =
        block([setter[0] - reach, setter[1] - reach, -400.0], [setter[0] + reach, setter[1] + reach, top]);
    let mut shop = among(&[body], [setter[0], setter[1], -60.0]);
    let parameter = |shop: &mut Shop, name: &str| {
        let Reply::Parameters { parameters, .. } = shop.say(Command::Parameters { names: vec![name.into()] })
        else {
            panic!()
        };
        parameters[name]
    };
    // The setter by a tool of known length that stands over it.
    let found =
        measure(&mut shop, command(json!({"mode": "calibrate_length", "length": length}), "measure_tool"));
    assert_eq!(found.unwrap().stored, ["P387", "P388", "P389"]);
    near(parameter(&mut shop, "P387"), setter[0]);
    near(parameter(&mut shop, "P388"), setter[1]);
    near(parameter(&mut shop, "P389"), setter[2]);
    let asked = json!({"mode": "calibrate_diameter", "length": length, "diameter": diameter, "stylus": 5.0});
    assert_eq!(measure(&mut shop, command(asked, "measure_tool")).unwrap().stored, ["P391"]);
    near(parameter(&mut shop, "P391"), stylus);

    // Now the tool, estimated 1.5 too long and 0.6 too thick, from elsewhere; an old wear goes.
    let wear = json!({"do": "set_offset", "number": 4, "length_wear": 0.3, "radius": 4.0});
    shop.say(serde_json::from_value(wear).unwrap());
    shop.mode(Mode::Mdi);
    shop.say(Command::Mdi { text: "G0 X-30 Y10".into() });
    shop.start();
    shop.until_it_stops();
    shop.mode(Mode::Auto);
    shop.events.clear();
    let asked = json!({"mode": "both", "h": 4, "d": 4, "length": 84.0, "diameter": 10.6, "rpm": -300});
    let found = measure(&mut shop, command(asked, "measure_tool")).unwrap();
    near(found.sizes[0], length);
    near(found.sizes[1], diameter);
    assert_eq!(found.stored, ["H4", "D4"]);
    assert_eq!(shop.wait(1).spindle.told, 0.0);
    let Reply::Offsets { offsets } = shop.say(Command::Offsets { from: 4, to: 4 }) else { panic!() };
    near(offsets[&4].length.unwrap(), length);
    assert_eq!(offsets[&4].length_wear, Some(0.0));
    near(offsets[&4].radius.unwrap(), diameter / 2.0);
    // It broke since: 3 mm shorter than its offset.
    let mut broken = json!({"mode": "length", "h": 4, "length": 85.5, "tolerance": 0.5});
    assert_eq!(measure(&mut shop, command(broken.clone(), "measure_tool")).unwrap_err(), "FC-1475");
    shop.say(Command::Reset);
    shop.wait(20);
    // One that misses the setter goes no farther than it may.
    let short = json!({"mode": "length", "h": 4, "length": 95.0});
    assert_eq!(measure(&mut shop, command(short, "measure_tool")).unwrap_err(), "gsk990mc:0283");
    shop.say(Command::Reset);
    shop.wait(20);
    // The mark of a broken tool: on, and off again with one that is whole.
    let mark = |shop: &mut Shop| match shop.say(Command::Offsets { from: 9, to: 9 }) {
        Reply::Offsets { offsets } => offsets[&9].length,
        other => panic!("{other:?}"),
    };
    broken["mark"] = json!(9);
    assert_eq!(measure(&mut shop, command(broken.clone(), "measure_tool")).unwrap_err(), "FC-1475");
    assert_eq!(mark(&mut shop), Some(1.0));
    shop.say(Command::Reset);
    shop.wait(20);
    broken["tolerance"] = json!(5.0);
    assert!(measure(&mut shop, command(broken.clone(), "measure_tool")).is_ok());
    assert_eq!(mark(&mut shop), Some(0.0));
    // It is a number of its own; and no size is within a tolerance below 0.
    broken["mark"] = json!(4);
    assert_eq!(shop.refused(command(broken.clone(), "measure_tool")), "FC-1476");
    (broken["mark"], broken["tolerance"]) = (json!(9), json!(-0.001));
    assert_eq!(shop.refused(command(broken, "measure_tool")), "FC-1476");
    // The radius is made smaller by the adjustment I.
    let asked =
        json!({"mode": "diameter", "d": 4, "length": 84.0, "diameter": 10.6, "rpm": -300, "adjust": 0.01});
    let found = measure(&mut shop, command(asked, "measure_tool")).unwrap();
    near(found.sizes[0], diameter);
    let Reply::Offsets { offsets } = shop.say(Command::Offsets { from: 4, to: 4 }) else { panic!() };
    near(offsets[&4].radius.unwrap(), diameter / 2.0 - 0.01);
    // NO4.0: without a setter there is none to measure on.
    shop.mode(Mode::Mdi);
    shop.say(Command::ParameterSwitch { on: true });
    shop.say(Command::SetParameter { name: "NO4.0".into(), value: Some(0.0) });
    shop.say(Command::AcceptParameterSwitch);
    shop.mode(Mode::Auto);
    let asked = json!({"mode": "length", "h": 4});
    assert_eq!(shop.refused(command(asked, "measure_tool")), "gsk990mc:0282");
}

/// The length asked for: given, else that of the offset, else P390.
#[test]
fn a_length_that_nobody_gave_is_that_of_the_offset_or_of_the_parameter() {
    let (setter, length) = ([60.0, -40.0, -180.0], 82.5);
    let body = block([50.0, -50.0, -400.0], [70.0, -30.0, setter[2] + length]);
    // Offset H 4, P390, and what comes of it: found only within 4 mm of the estimate.
    for (h, estimate, wanted) in [
        (0.0, 0.0, Err("FC-1476")),
        (0.0, 84.0, Ok(())),
        (0.0, 90.0, Err("gsk990mc:0283")),
        (84.0, 90.0, Ok(())),
        (90.0, 84.0, Err("gsk990mc:0283")),
    ] {
        let mut machine = machine();
        for (name, value) in
            [("P387", setter[0]), ("P388", setter[1]), ("P389", setter[2]), ("P390", estimate)]
        {
            machine.parameters.insert(name.to_owned(), value);
        }
        let mut shop = among_of(&machine, &[body], [0.0, 0.0, -60.0]);
        let offset = json!({"do": "set_offset", "number": 4, "length": h});
        shop.say(serde_json::from_value(offset).unwrap());
        let asked = command(json!({"mode": "length", "h": 4}), "measure_tool");
        let found = measure(&mut shop, asked).map(|found| near(found.sizes[0], length));
        assert_eq!(found, wanted.map_err(str::to_owned), "H {h}, P390 {estimate}");
        if found.is_err() {
            shop.say(Command::Reset);
            shop.wait(20);
        }
        // A calibration takes neither.
        let calibrate = command(json!({"mode": "calibrate_length", "h": 4}), "measure_tool");
        assert_eq!(shop.refused(calibrate), "FC-1476");
    }
}

#[test]
fn points_by_hand_give_a_centre() {
    let mut shop = Shop::new(&[]);
    let go = |shop: &mut Shop, x: f64, y: f64, number: u8| {
        shop.mode(Mode::Mdi);
        shop.say(Command::Mdi { text: format!("G90 G0 X{x} Y{y}") });
        shop.start();
        shop.until_it_stops();
        shop.say(Command::TouchPoint { number });
    };
    // 3.4.3.1, A 4: three points of a circle about 10, 20.
    go(&mut shop, 15.0, 20.0, 1);
    go(&mut shop, 10.0, 25.0, 2);
    let circle = Command::Centre { circle: true, system: Some("G54".into()), values: Default::default() };
    assert_eq!(shop.refused(circle.clone()), "FC-1473");
    go(&mut shop, 5.0, 20.0, 3);
    let Reply::Measured { measured, .. } = shop.say(circle.clone()) else { panic!() };
    near(measured.unwrap().sizes[0], 10.0);
    let set = zero(&mut shop, "G54");
    near(set[0], 10.0);
    near(set[1], 20.0);
    // On a line; all in one place.
    shop.say(Command::SetZero { system: "G54".into(), axes: [('X', 0.0), ('Y', 0.0)].into(), add: false });
    shop.say(Command::ClearPoints);
    for (number, x) in [(1, 1.0), (2, 2.0), (3, 3.0)] {
        go(&mut shop, x, x, number);
    }
    assert_eq!(shop.refused(circle.clone()), "FC-1473");
    for number in [1, 2, 3] {
        go(&mut shop, 7.0, 8.0, number);
    }
    shop.say(circle);
    near(zero(&mut shop, "G54")[0], 7.0);
    // Four points of a rectangle: X of the first two, Y of the others.
    let rectangle =
        Command::Centre { circle: false, system: Some("G56".into()), values: [('Y', 5.0)].into() };
    assert_eq!(shop.refused(rectangle.clone()), "FC-1473");
    shop.say(Command::SetZero { system: "G54".into(), axes: [('X', 0.0), ('Y', 0.0)].into(), add: false });
    for (number, x, y) in [(1, -10.0, 3.0), (2, 30.0, -2.0), (3, 1.0, 50.0), (4, 9.0, -20.0)] {
        go(&mut shop, x, y, number);
    }
    let Reply::Points { points } = shop.say(Command::Points) else { panic!() };
    assert_eq!((points.len(), points[&2][&'X']), (4, 30.0));
    let Reply::Measured { measured, .. } = shop.say(rectangle) else { panic!() };
    assert_eq!(measured.unwrap().sizes, [40.0, 70.0]);
    let set = zero(&mut shop, "G56");
    assert_eq!([set[0], set[1]], [10.0, 10.0]);
    assert_eq!(shop.refused(Command::TouchPoint { number: 9 }), "FC-1409");
}
