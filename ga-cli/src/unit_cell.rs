//! Decides what JSON tells of a unit cell, in every command that has one.

use ga_design::crystallography::Cell;
use serde::Serialize;

/// The six parameters, and what follows from them.
#[derive(Debug, Serialize)]
pub struct UnitCell {
    /// In ångström.
    pub a: f64,
    /// In ångström.
    pub b: f64,
    /// In ångström.
    pub c: f64,
    /// Between b and c, in radians.
    pub alpha: f64,
    /// Between c and a, in radians.
    pub beta: f64,
    /// Between a and b, in radians.
    pub gamma: f64,
    /// The same in degrees.
    pub alpha_deg: f64,
    /// The same in degrees.
    pub beta_deg: f64,
    /// The same in degrees.
    pub gamma_deg: f64,
    /// In cubic ångström.
    pub volume: f64,
}

impl UnitCell {
    /// Of a cell.
    pub fn of(cell: &Cell) -> Self {
        let [a, b, c] = cell.edges();
        let [alpha_deg, beta_deg, gamma_deg] = cell.angles();
        Self {
            a,
            b,
            c,
            alpha: alpha_deg.to_radians(),
            beta: beta_deg.to_radians(),
            gamma: gamma_deg.to_radians(),
            alpha_deg,
            beta_deg,
            gamma_deg,
            volume: cell.volume(),
        }
    }
}
