//! The elements of the conformal model against plain vector geometry.

#[path = "elements/circles.rs"]
mod circles;
#[path = "elements/classification.rs"]
mod classification;
#[path = "elements/construction.rs"]
mod construction;
#[path = "elements/duals.rs"]
mod duals;
#[path = "elements/extreme_sizes.rs"]
mod extreme_sizes;
#[path = "elements/far_places.rs"]
mod far_places;
#[path = "elements/incidence.rs"]
mod incidence;
#[path = "elements/measures.rs"]
mod measures;
#[path = "elements/meets.rs"]
mod meets;
#[path = "elements/number_types.rs"]
mod number_types;
#[path = "elements/odd_input.rs"]
mod odd_input;
#[path = "elements/oracle.rs"]
mod oracle;
#[path = "elements/point_pairs.rs"]
mod point_pairs;
#[path = "elements/round_trips.rs"]
mod round_trips;
#[path = "elements/surrounds.rs"]
mod surrounds;
