//! The laboratory's commands.

mod accuracy;
mod compare;
mod costs;
mod film;
mod flight;
mod stress;
