//! Names of layers and blocks: how they are encoded, and a number for each.
//!
//! Order of encodings: strict UTF-8 (all files since R2007), then the code page that the drawing names
//! (`$DWGCODEPAGE`), then a guess with Chinese as the hint. `\U+4E2D` stands for a character in any of
//! them. Capitals do not count in names.

use encoding_rs::Encoding;
use rustc_hash::FxHashMap;

/// The encoding that `$DWGCODEPAGE` names; `None` where it is not known.
pub fn code_page(name: &[u8]) -> Option<&'static Encoding> {
    let name = std::str::from_utf8(name).ok()?.to_ascii_uppercase();
    let label = match name.strip_prefix("ANSI_").or_else(|| name.strip_prefix("DOS")).unwrap_or(&name) {
        // GBK is the part of GB18030 that the page knows by this number.
        "936" | "GB2312" => "gb18030",
        "932" => "shift_jis",
        "949" | "JOHAB" | "1361" => "euc-kr",
        "950" | "BIG5" => "big5",
        "874" => "windows-874",
        "UTF8" | "UTF-8" => "utf-8",
        "866" => "ibm866",
        page @ ("1250" | "1251" | "1252" | "1253" | "1254" | "1255" | "1256" | "1257" | "1258") => {
            return Encoding::for_label(format!("windows-{page}").as_bytes());
        }
        _ => return None,
    };
    Encoding::for_label(label.as_bytes())
}

/// A name as it is read.
pub fn decode(bytes: &[u8], page: Option<&'static Encoding>) -> String {
    let text = match (std::str::from_utf8(bytes), page) {
        (Ok(text), _) => text.to_owned(),
        (Err(_), Some(page)) => page.decode_without_bom_handling(bytes).0.into_owned(),
        (Err(_), None) => {
            let mut detector = chardetng::EncodingDetector::new(chardetng::Iso2022JpDetection::Deny);
            detector.feed(bytes, true);
            let guess = detector.guess(Some(b"cn"), chardetng::Utf8Detection::Deny);
            guess.decode_without_bom_handling(bytes).0.into_owned()
        }
    };
    unescaped(&text)
}

/// Replaces `\U+XXXX`.
fn unescaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once("\\U+") {
        out.push_str(before);
        let character =
            after.get(..4).and_then(|hex| u32::from_str_radix(hex, 16).ok()).and_then(char::from_u32);
        match (character, after.get(4..)) {
            (Some(character), Some(behind)) => {
                out.push(character);
                rest = behind;
            }
            _ => {
                out.push_str("\\U+");
                rest = after;
            }
        }
    }
    out.push_str(rest);
    out
}

/// A number for each name, whatever its capitals.
#[derive(Default)]
pub struct Names {
    numbers: FxHashMap<Box<[u8]>, u32>,
    names: Vec<Box<[u8]>>,
}

impl Names {
    /// The number of a name, a new one where it was not seen yet.
    pub fn number(&mut self, name: &[u8]) -> u32 {
        // Only ASCII letters: in the old code pages the bytes of others are not letters one by one.
        let folded = name.to_ascii_uppercase().into_boxed_slice();
        let next = u32::try_from(self.names.len()).unwrap_or(u32::MAX);
        *self.numbers.entry(folded).or_insert_with(|| {
            self.names.push(name.into());
            next
        })
    }

    /// The name with a number, as it was first written.
    pub fn bytes(&self, number: u32) -> &[u8] {
        self.names.get(number as usize).map_or(&[], |name| name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_in_the_drawings_encoding() {
        let gb = [0xB2, 0xE3];
        assert_eq!(decode("层".as_bytes(), None), "层");
        assert_eq!(decode(&gb, code_page(b"ANSI_936")), "层");
        assert_eq!(decode(b"A\\U+5C42B\\U+zz", None), "A层B\\U+zz");
        assert_eq!(decode("\\U+é".as_bytes(), None), "\\U+é");
        assert_eq!(decode(&[0xE4], code_page(b"ansi_1252")), "ä");
        assert!(code_page(b"ANSI_9999").is_none());
    }

    #[test]
    fn capitals_do_not_make_another_name() {
        let mut names = Names::default();
        assert_eq!((names.number(b"Cut"), names.number(b"x"), names.number(b"CUT")), (0, 1, 0));
        assert_eq!(names.bytes(0), b"Cut");
    }
}
