//! How the text of a program file is encoded.
//!
//! Order, as found to work for shops in China and elsewhere: a byte order mark; strict UTF-8; else a
//! guess with GB18030 as the hint. Only what people read (comments, names) is ever decoded; files
//! keep their bytes.

use std::borrow::Cow;

/// U+FEFF in GB18030, which the Encoding Standard does not count among the marks.
const GB18030_MARK: [u8; 4] = [0x84, 0x31, 0x95, 0x33];

/// Encoding of a program file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Encoding {
    encoding: &'static encoding_rs::Encoding,
    /// Length of the byte order mark, bytes.
    pub mark: usize,
}

impl Default for Encoding {
    fn default() -> Encoding {
        Encoding { encoding: encoding_rs::UTF_8, mark: 0 }
    }
}

impl Encoding {
    /// Detects the encoding from the first bytes of a file. `is_all` tells that there are no others;
    /// else a character cut at the end does not count against UTF-8.
    pub fn detect(start: &[u8], is_all: bool) -> Encoding {
        if let Some((encoding, mark)) = encoding_rs::Encoding::for_bom(start) {
            return Encoding { encoding, mark };
        }
        if start.starts_with(&GB18030_MARK) {
            return Encoding { encoding: encoding_rs::GB18030, mark: GB18030_MARK.len() };
        }
        let is_utf8 = match std::str::from_utf8(start) {
            Ok(_) => true,
            Err(e) => e.error_len().is_none() && !is_all,
        };
        if is_utf8 {
            return Encoding::default();
        }
        let mut detector = chardetng::EncodingDetector::new(chardetng::Iso2022JpDetection::Deny);
        detector.feed(start, is_all);
        let guess = detector.guess(Some(b"cn"), chardetng::Utf8Detection::Deny);
        // GBK is the part of GB18030 that guesses know by name.
        let encoding = if guess == encoding_rs::GBK { encoding_rs::GB18030 } else { guess };
        Encoding { encoding, mark: 0 }
    }

    /// Whether text in it is made of single bytes for ASCII, as the lexer needs. UTF-16 is not.
    pub fn is_ascii_based(self) -> bool {
        self.encoding.is_ascii_compatible()
    }

    /// Its name, such as `UTF-8` or `gb18030`.
    pub fn name(self) -> &'static str {
        self.encoding.name()
    }

    /// Bytes of the file as text; what cannot be decoded becomes �.
    pub fn decode(self, bytes: &[u8]) -> Cow<'_, str> {
        self.encoding.decode_without_bom_handling(bytes).0
    }

    /// For bytes that come in pieces.
    pub fn decoder(self) -> Decoder {
        Decoder(self.encoding.new_decoder_without_bom_handling())
    }
}

/// Decodes bytes that come in pieces: what of a character is cut off at the end of one is kept for the next.
pub struct Decoder(encoding_rs::Decoder);

impl Decoder {
    /// A piece as text; `is_last` tells that nothing follows. What cannot be decoded becomes �.
    pub fn decode(&mut self, piece: &[u8], is_last: bool) -> String {
        let mut text = String::new();
        // None where the length is beyond what a computer can count.
        text.reserve(self.0.max_utf8_buffer_length(piece.len()).unwrap_or(0));
        let _ = self.0.decode_to_string(piece, &mut text, is_last);
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_encodings_of_shops_are_told_apart() {
        let text = "O1 (铣削平面 精加工)\nG0 X1 (换刀后检查)\n";
        let (gb, _, _) = encoding_rs::GB18030.encode(text);
        assert_eq!(Encoding::detect(text.as_bytes(), true).name(), "UTF-8");
        let found = Encoding::detect(&gb, true);
        assert_eq!(found.name(), "gb18030");
        assert_eq!(found.decode(&gb), text);
        assert_eq!(Encoding::detect(b"\xEF\xBB\xBFG0", true).mark, 3);
        assert_eq!(Encoding::detect(b"G0 X1", true).name(), "UTF-8");
        assert!(!Encoding::detect(b"\xFF\xFEG\x000\x00", true).is_ascii_based());
        for cut in 0..gb.len() {
            let mut decoder = found.decoder();
            let whole = decoder.decode(&gb[..cut], false) + &decoder.decode(&gb[cut..], true);
            assert_eq!(whole, text, "cut at {cut}");
        }
        let cut = &text.as_bytes()[..text.len() - 5];
        let cut = &cut[..cut.len() - 1];
        assert_eq!(Encoding::detect(cut, false).name(), "UTF-8");
    }
}
