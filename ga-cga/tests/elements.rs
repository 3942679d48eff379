//! The elements of the conformal model against plain vector geometry.

#[path = "elements/classification.rs"]
mod classification;
#[path = "elements/construction.rs"]
mod construction;
#[path = "elements/incidence.rs"]
mod incidence;
#[path = "elements/measures.rs"]
mod measures;
#[path = "elements/meets.rs"]
mod meets;
#[path = "elements/odd_input.rs"]
mod odd_input;
#[path = "elements/oracle.rs"]
mod oracle;
#[path = "elements/queries.rs"]
mod queries;
