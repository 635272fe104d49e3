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

impl Symbol {
    /// The symbol that a text names; Greek letters may be spelled, and signs between letters left out:
    /// `K_Hβ`, `K_H_beta`, `KHbeta`.
    ///
    /// ```
    /// use epicyclic_strength::factor::Symbol;
    ///
    /// assert_eq!(Symbol::named("K_H_beta"), Some(Symbol::FaceContact));
    /// assert_eq!(Symbol::named("Z_D"), Some(Symbol::SingleContact));
    /// assert_eq!(Symbol::named("Y_delta_rel_T_stat"), Some(Symbol::StaticNotchSensitivity));
    /// assert_eq!(Symbol::named("K_X"), None);
    /// ```
    #[must_use]
    pub fn named(text: &str) -> Option<Self> {
        let of = |symbol: &&Self| symbol.to_string().split(", ").any(|name| plain(name) == plain(text));
        Self::ALL.iter().find(of).copied()
    }

    /// Whether its factor is at least 1, as all load factors are.
    #[must_use]
    pub const fn is_at_least_one(self) -> bool {
        matches!(
            self,
            Self::Application
                | Self::LoadSharing
                | Self::Dynamic
                | Self::FaceContact
                | Self::TransverseContact
                | Self::FaceRoot
                | Self::TransverseRoot
        )
    }

    /// Whether its factor is of a mesh, not of one of its gears.
    #[must_use]
    pub const fn is_of_mesh(self) -> bool {
        (self as usize) < Self::SingleContact as usize
    }
}

/// A symbol in letters of the keyboard, without signs between them.
fn plain(symbol: &str) -> String {
    let letter = |letter: char| match letter {
        '_' | ',' | ' ' => String::new(),
        'α' => "alpha".to_owned(),
        'β' => "beta".to_owned(),
        'γ' => "gamma".to_owned(),
        'δ' => "delta".to_owned(),
        'ε' => "epsilon".to_owned(),
        letter => letter.to_string(),
    };
    symbol.chars().map(letter).collect()
}

/// Number of symbols.
pub(crate) const SYMBOLS: usize = Symbol::MeanStress as usize + 1;
