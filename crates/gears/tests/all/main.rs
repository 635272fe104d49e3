//! Gear sets against second ways. One program: its tests run side by side.

mod arrangements;
mod double_planets;
mod inertia_by_quadrature;
mod interference_by_polygons;
mod practice;
mod tooth_numbers;
