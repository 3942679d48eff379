//! Versors of rigid motions: rotors, translators and motors.

mod motor;
mod rotor;
mod translator;
