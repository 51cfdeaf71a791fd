//! The control languages, one folder each, and what the Fanuc-like ones have in common.

pub mod fagor8065;
pub mod fanuc;
pub mod gsk990mc;
pub mod guess;
pub mod kaitong;
pub mod rs274;
pub mod weihong;

use crate::dialect::Dialect;

/// Every control language.
pub const ALL: &[&Dialect] =
    &[&gsk990mc::DIALECT, &kaitong::DIALECT, &weihong::DIALECT, &fagor8065::DIALECT, &rs274::DIALECT];

/// The control language with this name.
pub fn by_name(name: &str) -> Option<&'static Dialect> {
    ALL.iter().find(|d| d.name == name).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_in_rising_order_so_that_look_ups_find_every_row() {
        for Dialect { name, g_codes, m_codes, addresses, .. } in ALL {
            assert!(g_codes.windows(2).all(|w| w[0].tenths < w[1].tenths), "{name}");
            assert!(m_codes.windows(2).all(|w| w[0].code < w[1].code), "{name}");
            assert!(addresses.windows(2).all(|w| w[0].letter < w[1].letter), "{name}");
        }
    }
}
