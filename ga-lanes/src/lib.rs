//! Batches of generated elements, computed in SIMD lanes chosen at run time.

mod batch;
mod dispatch;
mod lanes;
mod methods;
mod number;
mod operand;
mod operation;
mod partial;
mod target;
mod task;

pub use batch::Batch;
pub use dispatch::{Kernel, dispatch, dispatch_on};
pub use lanes::Lanes;
pub use methods::LengthMismatch;
pub use number::Number;
pub use operand::{One, Operand};
pub use operation::{Map, ZipMap};
pub use partial::Partial;
pub use target::Target;
