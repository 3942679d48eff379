//! Linkages: frames, joints, chains and the tables that they are read from.

mod loops;
mod poses;
mod tables;
mod urdf;
