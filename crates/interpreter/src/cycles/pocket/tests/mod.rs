//! Profile pockets.
mod deep;
mod faults;
mod finish;
mod flat;
mod manual;
mod mill;
mod paths;
mod program;
mod random;
mod stored;
