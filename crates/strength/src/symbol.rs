//! Symbols of the factors, as ISO 6336 writes them.

epicyclic_gears::words! {
    /// The symbol of a factor, `K_Hβ`; displays as ISO 6336 writes it.
    Symbol {
        Application "K_A"
        LoadSharing "K_γ"
        Dynamic "K_v"
        FaceContact "K_Hβ"
        TransverseContact "K_Hα"
        FaceRoot "K_Fβ"
        TransverseRoot "K_Fα"
        Zone "Z_H"
        Elasticity "Z_E"
        ContactRatio "Z_ε"
        HelixContact "Z_β"
        SingleContact "Z_B, Z_D"
        LifeContact "Z_NT"
        Lubricant "Z_L"
        Velocity "Z_v"
        Roughness "Z_R"
        WorkHardening "Z_W"
        SizeContact "Z_X"
        Form "Y_F"
        StressCorrection "Y_S"
        HelixRoot "Y_β"
        RimThickness "Y_B"
        DeepTooth "Y_DT"
        TestGearStress "Y_ST"
        LifeRoot "Y_NT"
        NotchSensitivity "Y_δrelT"
        StaticNotchSensitivity "Y_δrelT,stat"
        SurfaceRoot "Y_RrelT"
        SizeRoot "Y_X"
        MeanStress "Y_M"
    }
}

/// How many there are.
pub(crate) const SYMBOLS: usize = Symbol::MeanStress as usize + 1;
