//! Centre distances, clearance, assembly and undercut of the sets of a gearbox.
