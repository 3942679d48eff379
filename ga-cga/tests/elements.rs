//! The elements of the conformal model against plain vector geometry.

#[path = "elements/classification.rs"]
mod classification;
#[path = "elements/construction.rs"]
mod construction;
#[path = "elements/oracle.rs"]
mod oracle;
#[path = "elements/queries.rs"]
mod queries;
