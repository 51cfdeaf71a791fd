//! Paths beside walls.

use super::super::polygons;
use super::super::ring::Ring;
use super::super::walls::Walls;
use super::random::{circle, drawing, rectangle};

/// Area that rings enclose, mm².
fn area(rings: &[Ring]) -> f64 {
    rings.iter().flat_map(|r| &r.segments).map(|s| s.double_area()).sum::<f64>() / 2.0
}

#[test]
fn many_random_walls() {
    let mut count = 0;
    for number in 0..1500 {
        let (outer, islands, mut dice) = drawing(number);
        let walls = Walls::new([&outer], &islands);
        for k in 0..5 {
            let d = if number % 2 == 0 { dice.between(0.2, 5.0) } else { 0.5 + f64::from(k) };
            match walls.paths(d) {
                Ok(rings) => count += rings.len(),
                Err(problem) => panic!("{problem:?} in {number} at {d}"),
            }
        }
    }
    assert!(count > 1000);
}

#[test]
fn full_circles_stay_whole() {
    let walls = Walls::new([&rectangle([-20.0, -20.0], [20.0, 20.0])], &[circle([0.0, 0.0], 5.0)]);
    let rings = walls.paths(2.0).unwrap();
    assert_eq!(rings.iter().map(|r| r.segments.len()).collect::<Vec<_>>(), [4, 1]);
    assert!((rings[1].length() - 14.0 * std::f64::consts::PI).abs() < 1e-9);
    assert!(area(&rings[1..]) < 0.0);
}

/// The way of straight pieces is close enough wherever it is asked.
#[test]
fn paths_of_straight_pieces() {
    for number in 0..300 {
        let (outer, islands, mut dice) = drawing(number);
        let walls = Walls::new([&outer], &islands);
        let d = dice.between(0.3, 4.0);
        let rings = polygons::paths(&walls.contours, d);
        assert!(walls.judge(&rings, d, 2.2e-3), "{number} at {d}");
        let exact = walls.paths(d).unwrap();
        let long: f64 = exact.iter().map(|r| r.length()).sum();
        assert!((area(&rings) - area(&exact)).abs() < 3e-3 * long + 1e-3, "{number} at {d}");
    }
}
