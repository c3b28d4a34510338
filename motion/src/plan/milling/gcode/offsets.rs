//! Coordinates: from those of a program to those of the machine.

/// X, Y, Z, A, B, C, U, V, W, and E of printers.
pub(super) const AXES: usize = 10;

/// Their letters.
pub(super) const LETTERS: [char; AXES] = ['X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W', 'E'];

/// A number for each axis, in mm or degrees.
pub(super) type Axes = [f64; AXES];

/// Work coordinate systems, G54 to G59.3.
const SYSTEMS: usize = 9;

/// A coordinate system: where its origin is, and how far it is turned about Z, in degrees.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct System {
    pub(super) origin: Axes,
    pub(super) turn: f64,
}

/// All offsets.
#[derive(Debug, Clone)]
pub(super) struct Offsets {
    pub(super) systems: [System; SYSTEMS],
    /// Which one is in force.
    pub(super) current: usize,
    /// Of G92.
    pub(super) shift: Axes,
    pub(super) is_shifted: bool,
    /// Of G52.
    pub(super) local: Axes,
    /// Of the tool in force.
    pub(super) tool: Axes,
}

impl Offsets {
    pub(super) fn new() -> Self {
        let none = [0.0; AXES];
        Self {
            systems: [System::default(); SYSTEMS],
            current: 0,
            shift: none,
            is_shifted: false,
            local: none,
            tool: none,
        }
    }

    pub(super) fn system(&self) -> &System {
        &self.systems[self.current]
    }

    /// All that is added after the turn.
    pub(super) fn sum(&self, axis: usize) -> f64 {
        let shift = if self.is_shifted { self.shift[axis] } else { 0.0 };
        self.system().origin[axis] + shift + self.local[axis] + self.tool[axis]
    }

    /// Coordinates of the program, of a point of the machine.
    pub(super) fn to_program(&self, machine: &Axes) -> Axes {
        let mut point = *machine;
        for (axis, coordinate) in point.iter_mut().enumerate() {
            *coordinate -= self.sum(axis);
        }
        turned(&mut point, -self.system().turn);
        point
    }

    /// Coordinates of the machine, of a point of the program.
    pub(super) fn to_machine(&self, program: &Axes) -> Axes {
        let mut point = *program;
        turned(&mut point, self.system().turn);
        for (axis, coordinate) in point.iter_mut().enumerate() {
            *coordinate += self.sum(axis);
        }
        point
    }
}

/// About Z, by degrees.
pub(super) fn turned(point: &mut Axes, degrees: f64) {
    if degrees != 0.0 {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        (point[0], point[1]) = (point[0] * cosine - point[1] * sine, point[0] * sine + point[1] * cosine);
    }
}
