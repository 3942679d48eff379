//! What is exported is opened by programs of other people, measured, and refused where it must be.

mod demo;
mod failures;
mod instances;
mod meshes;
mod page;
mod pictures;
mod properties;
mod readers;
