//! Bytes that act at once, wherever in a line they stand (Grbl 1.1, real-time commands).

/// What a byte asks for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Realtime {
    /// 0x18.
    Reset,
    /// `?`
    Status,
    /// `~`
    Start,
    /// `!`
    Hold,
    /// 0x84
    Door,
    /// 0x85
    CancelJog,
    /// 0x90 to 0x94: to this many percent, or by this many.
    Feed(Change),
    /// 0x95 to 0x97, percent.
    Rapid(u16),
    /// 0x99 to 0x9D.
    Spindle(Change),
    /// 0x9E: the spindle stops or starts in a hold.
    SpindleStop,
    /// 0xA0
    Flood,
    /// 0xA1
    Mist,
    /// Any other byte that is no text: dropped. A sender that writes bytes from 0x80 on as UTF-8 puts such a one
    /// before them.
    Nothing,
}

/// A change of an override.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Change {
    /// To 100 %.
    Back,
    /// By percent points.
    By(i16),
}

impl Change {
    /// The override behind it, 10 to 200 %.
    pub fn of(self, percent: u16) -> u16 {
        match self {
            Change::Back => 100,
            Change::By(points) => percent.saturating_add_signed(points).clamp(10, 200),
        }
    }
}

/// What a byte asks for at once; `None` for one that belongs to a line.
pub fn realtime(byte: u8) -> Option<Realtime> {
    Some(match byte {
        0x18 => Realtime::Reset,
        b'?' => Realtime::Status,
        b'~' => Realtime::Start,
        b'!' => Realtime::Hold,
        0x84 => Realtime::Door,
        0x85 => Realtime::CancelJog,
        0x90 => Realtime::Feed(Change::Back),
        0x91 => Realtime::Feed(Change::By(10)),
        0x92 => Realtime::Feed(Change::By(-10)),
        0x93 => Realtime::Feed(Change::By(1)),
        0x94 => Realtime::Feed(Change::By(-1)),
        0x95 => Realtime::Rapid(100),
        0x96 => Realtime::Rapid(50),
        0x97 => Realtime::Rapid(25),
        0x99 => Realtime::Spindle(Change::Back),
        0x9A => Realtime::Spindle(Change::By(10)),
        0x9B => Realtime::Spindle(Change::By(-10)),
        0x9C => Realtime::Spindle(Change::By(1)),
        0x9D => Realtime::Spindle(Change::By(-1)),
        0x9E => Realtime::SpindleStop,
        0xA0 => Realtime::Flood,
        0xA1 => Realtime::Mist,
        0x80.. => Realtime::Nothing,
        _ => return None,
    })
}
