//! Findings point at the words at fault: by line, column and length as JSON, by carets in a terminal.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod common;

use common::{ferrocut, json, json_lines, write};
use serde_json::Value;

/// Five faults: an unknown G code behind a Chinese remark and a tab, a feed of nought, an arc whose
/// end is off its circle, a subprogram that is not there behind a tab, a move beyond the travel.
const FIVE: &str = "O1 (五个错误)\n\
    G0 X1 M3 S1000\n\
    (铣平面)\tG77 X5\n\
    G1 X10 F0\n\
    G2 X30 Y5 I10 (圆弧)\n\
    \tM98 P777\n\
    G0 X600\n\
    M5\n\
    M30\n";

/// Of each: line, column, words, alarm.
const EXPECTED: [(u64, u64, &str, &str); 5] = [
    // The remark is 5 characters, the tab one.
    (3, 7, "G77", "gsk990mc:0010"),
    (4, 8, "F0", "gsk990mc:0011"),
    (5, 1, "G2 X30 Y5 I10", "gsk990mc:0020"),
    (6, 6, "P777", "gsk990mc:0078"),
    (7, 4, "X600", "gsk990mc:0501"),
];

fn check_json(bytes: &[u8]) {
    let folder = tempfile::tempdir().unwrap();
    let file = write(&folder, "five.nc", bytes);
    let answer = ferrocut(&["check", &file, "--format", "json"]);
    assert_eq!((answer.code, answer.err.as_str()), (1, ""));
    let findings = json_lines(&answer.out);
    let of = |f: &Value| {
        let place = |key: &str| f[key].as_u64().unwrap();
        (place("line"), place("column"), place("length"), f["alarm"].as_str().unwrap().to_owned())
    };
    let expected = EXPECTED
        .map(|(line, column, words, alarm)| (line, column, words.chars().count() as u64, alarm.to_owned()));
    assert_eq!(findings.iter().map(of).collect::<Vec<_>>(), expected);
    for finding in &findings {
        assert_eq!(
            (finding["file"].as_str(), finding["severity"].as_str()),
            (Some(file.as_str()), Some("error"))
        );
        assert!(!finding["message"].as_str().unwrap().is_empty(), "{finding}");
        assert!(!finding["help"].as_str().unwrap().is_empty(), "{finding}");
    }
}

#[test]
fn five_faults_are_all_reported_with_their_words() {
    check_json(FIVE.as_bytes());
}

#[test]
fn columns_are_characters_in_every_encoding() {
    check_json(FIVE.replace('\n', "\r\n").as_bytes());
    // The same in GB18030: two bytes a character.
    let mut gb = Vec::new();
    let table: &[(&str, &[u8])] = &[
        ("五个错误", b"\xce\xe5\xb8\xf6\xb4\xed\xce\xf3"),
        ("铣平面", b"\xcf\xb3\xc6\xbd\xc3\xe6"),
        ("圆弧", b"\xd4\xb2\xbb\xa1"),
    ];
    let mut rest = FIVE;
    while !rest.is_empty() {
        match table.iter().find(|(text, _)| rest.starts_with(text)) {
            Some((text, bytes)) => {
                gb.extend_from_slice(bytes);
                rest = &rest[text.len()..];
            }
            None => {
                gb.push(rest.as_bytes()[0]);
                rest = &rest[1..];
            }
        }
    }
    check_json(&gb);
    // A byte order mark is no character.
    check_json(format!("\u{FEFF}{FIVE}").as_bytes());
}

/// Columns of a terminal that a text takes: Chinese characters are two wide.
fn width(text: &str) -> usize {
    text.chars().map(|c| if c as u32 >= 0x1100 { 2 } else { 1 }).sum()
}

#[test]
fn carets_stand_under_the_words() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(&folder, "five.nc", FIVE);
    let answer = ferrocut(&["check", &file]);
    assert_eq!(answer.code, 1);
    assert!(!answer.out.contains('\u{1b}'), "colours in a pipe");
    let lines: Vec<&str> = answer.out.lines().collect();
    for (line, column, words, alarm) in EXPECTED {
        let title = lines.iter().position(|l| l.contains(alarm)).unwrap_or_else(|| panic!("no {alarm}"));
        assert!(lines[title].starts_with("error"), "{}", lines[title]);
        let place = format!("{file}:{line}:{column}");
        assert!(lines[title + 1].trim_end().ends_with(&place), "{} for {place}", lines[title + 1]);
        let source = (title..lines.len()).find(|i| lines[*i].starts_with(&format!("{line} |"))).unwrap();
        let (shown, carets) = (lines[source], lines[source + 1]);
        let before = &shown[..shown.find(words).unwrap_or_else(|| panic!("{words} is not in {shown}"))];
        let start = carets.find('^').unwrap_or_else(|| panic!("no caret under {shown}"));
        assert_eq!(width(&carets[..start]), width(before), "{shown}\n{carets}");
        assert_eq!(carets.matches('^').count(), words.len(), "{shown}\n{carets}");
        assert!(lines[source..source + 4].iter().any(|l| l.contains("help")), "{alarm} does not help");
    }
    // The last line says how many there were.
    assert!(lines.last().unwrap().contains('5'), "{:?}", lines.last());
}

#[test]
fn every_command_tells_the_first_fault_and_leaves_with_1() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(&folder, "five.nc", FIVE);
    for command in ["run", "trace", "time"] {
        let answer = ferrocut(&[command, &file]);
        assert_eq!(answer.code, 1, "{command}");
        assert!(
            answer.err.contains("gsk990mc:0010") && answer.err.contains("^^^"),
            "{command}: {}",
            answer.err
        );
        assert!(!answer.err.contains("gsk990mc:0011"), "{command} goes on: {}", answer.err);
        let answer = ferrocut(&[command, &file, "--format", "json"]);
        let finding = json(answer.err.trim());
        assert_eq!(
            (answer.code, finding["line"].as_u64(), finding["column"].as_u64()),
            (1, Some(3), Some(7))
        );
    }
    // A run reports what it did before.
    let answer = ferrocut(&["run", &file, "--format", "json"]);
    let report = json(&answer.out);
    assert_eq!((report["state"].as_str(), report["alarm"].as_str()), (Some("alarm"), Some("gsk990mc:0010")));
    assert_eq!((report["parts"].as_u64(), report["moves"].as_u64()), (Some(0), Some(1)));
}

#[test]
fn findings_of_many_files_come_in_the_order_of_the_files() {
    let folder = tempfile::tempdir().unwrap();
    let names: Vec<String> = (0..20).map(|n| format!("part-{n}.nc")).collect();
    let files: Vec<String> = names.iter().map(|name| write(&folder, name, "G0 X1\nG77\nM30\n")).collect();
    let mut arguments = vec!["check", "--format", "json"];
    arguments.extend(files.iter().map(String::as_str));
    let answer = ferrocut(&arguments);
    let found: Vec<String> =
        json_lines(&answer.out).iter().map(|f| f["file"].as_str().unwrap().to_owned()).collect();
    assert_eq!((answer.code, found), (1, files));
}

#[test]
fn a_fault_in_a_subprogram_names_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let main = write(&folder, "main.nc", "O1\nM98 P2002\nM30\n");
    write(&folder, "O2002.nc", "O2002\nG0 X1\nG1 X2 E7\nM99\n");
    let answer = ferrocut(&["check", &main, "--format", "json"]);
    let finding = json(answer.out.trim());
    assert!(finding["file"].as_str().unwrap().ends_with("O2002.nc"), "{finding}");
    assert_eq!((finding["line"].as_u64(), finding["column"].as_u64()), (Some(3), Some(7)));
}

#[test]
fn a_faulty_block_is_taken_as_reached_by_what_is_checked_behind_it() {
    // The circle is about (390, 0), well inside, whatever became of the block before it.
    let folder = tempfile::tempdir().unwrap();
    let file = write(&folder, "part.nc", "M3 S1000\nG0 X-400\nG1 X400 F0\nG2 I-10 F100\nM30\n");
    let answer = ferrocut(&["check", &file, "--format", "json"]);
    let found: Vec<_> =
        json_lines(&answer.out).iter().map(|f| f["alarm"].as_str().unwrap().to_owned()).collect();
    assert_eq!(found, ["gsk990mc:0011"]);
}

#[test]
fn warnings_are_findings_that_stop_no_run() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(&folder, "part.nc", "G0 X1\nG1 X2 F100\nX3\nM30\n");
    let answer = ferrocut(&["check", &file, "--format", "json"]);
    let finding = json(answer.out.trim());
    assert_eq!(
        (answer.code, finding["severity"].as_str(), finding["line"].as_u64()),
        (1, Some("warning"), Some(2))
    );
    let answer = ferrocut(&["run", &file]);
    assert_eq!(answer.code, 0);
    assert!(answer.err.starts_with("warning"), "{}", answer.err);
}

#[test]
fn a_fault_in_a_long_line_is_shown_with_what_is_near_it() {
    let folder = tempfile::tempdir().unwrap();
    let line = format!("{} G77 {}", "(0123456789)".repeat(40), "(abc)".repeat(40));
    let file = write(&folder, "part.nc", format!("G0 X1\n{line}\nM30\n"));
    let answer = ferrocut(&["check", &file]);
    assert!(answer.out.contains("^^^") && answer.out.contains("G77"), "{}", answer.out);
    assert!(answer.out.lines().all(|l| l.chars().count() < 220), "{}", answer.out);
    let answer = ferrocut(&["check", &file, "--format", "json"]);
    let finding = json(answer.out.trim());
    // 480 characters of remarks and a blank.
    assert_eq!((finding["column"].as_u64(), finding["length"].as_u64()), (Some(482), Some(3)));
}

#[test]
fn messages_in_chinese() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(&folder, "part.nc", "G77\nM30\n");
    let english = ferrocut(&["check", &file]).out;
    let chinese = ferrocut(&["check", &file, "--language", "zh"]).out;
    let is_chinese = |text: &str| text.chars().any(|c| ('\u{4e00}'..'\u{9fff}').contains(&c));
    assert!(!is_chinese(&english) && is_chinese(&chinese) && chinese.contains("gsk990mc:0010"));
    let by_lang = common::answer(common::command(&["check", &file]).env("LANG", "zh_CN.UTF-8")).out;
    assert_eq!(by_lang, chinese);
}
