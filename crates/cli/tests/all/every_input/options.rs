//! Every option of every command, by the program's own list of them.

use super::common::console::words;
use super::common::{examples, output, text};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// Command lines in which options have an effect, each with the options to add below it. An added option
/// replaces that of the line.
const TRIED: &str = "\
teeth: --ratio 6 --format json
  --ratio 5
  --mode Ha^b
  --tolerance 2%
  --planets 4
  --sun 20..
  --planet 40..
  --ring ..100
  --k 5..5
  --spacing least-unequal
  --tip-gap 1
  --addendum 0.8
  --pressure-angle 14.5deg
  --no-undercut
  --limit 3
  --save set.yaml
  --format csv
  --output sets.json
teeth: --ratio 6 --save set.yaml
  --nth 2
teeth: --ratio -1.6
  --double-planet
teeth: --ratio 6 --limit 5
  --ring-offset -3..3
teeth: --ratio 6.2 --ring-offset -3..3 --limit 5
  --aim tip-alteration
  --tip-thickness 0.7
select: --ratios 6.17 --teeth --limit 3 --sun ..22 --ring ..110 --format json
  --ring-offset -3..3
select: --ratios 6.17 --teeth --limit 3 --sun ..22 --ring ..110 --ring-offset -1..1 --format json --planet-speed 4
  --aim tip-alteration
  --tip-thickness 0.7
synthesize: --ratios '2.56, 1.465' --sets 2 --elements 2 --teeth --sun 17..60 --ring ..110 --planet-count 3 --teeth-limit 1 --limit 1 --format json
  --ring-offset -1..1
synthesize: --ratios '2.56, 1.465' --sets 2 --elements 2 --teeth --sun 17..60 --ring ..110 --planet-count 3 --teeth-limit 1 --limit 1 --ring-offset 1..2 --format json
  --aim tip-alteration
  --tip-thickness 0.7
teeth: --ratio 6 --no-undercut
  --pressure-angle 25deg
drive: minimal-drive.yaml
  --format csv
  --output drive.txt
drive: minimal-drive.yaml --output page.html
  --project 'Winch 7'
  --customer 'Mine North'
  --author 'A. Engineer'
  --date '22 November 2026'
  --paper letter
analyze: real-transmissions.yaml
  --transmission 8HP
analyze: real-transmissions.yaml --transmission 8HP
  --efficiency 97%
  --shifts
  --progression 1.05
analyze: every-gearbox-key.yaml --format json
  --gear 1
  --all-combinations
  --formula
  --steps
  --torque '500 N·m'
  --speed '1475 rpm'
analyze: every-gearbox-key.yaml --formula
  --gear 1
  --steps
  --format csv
analyze: II-3 --k1 2.15 --k2 2.35
  --k1 2.5
  --k2 2.5
  --formula
  --efficiency 97%
analyze: D.T1.B+T2.B.T1 --ratio1 2.618 --ratio2 1.4623
  --ratio1 2.5
  --ratio2 1.5
analyze: power-split.yaml --gear drive --format json
  --speeds 'engine=2000rpm, generator=1000rpm'
  --torques 'engine=50 N·m'
  --map 'engine=800rpm..4000rpm/3, generator=0rpm..5000rpm/2'
analyze: power-split.yaml --gear drive --speeds 'engine=2000rpm, generator=1000rpm' --format json
  --torques 'engine=50 N·m'
analyze: power-split.yaml --gear drive --map 'engine=800rpm..4000rpm/3, generator=0rpm..5000rpm/2'
  --torques 'engine=50 N·m'
analyze: every-gearbox-key.yaml --gear 1 --format json
  --torque '500 N·m'
  --speed '1475 rpm'
  --input '1475 rpm'
  --format csv
  --output box.json
analyze: every-gearbox-key.yaml --gear 1 --speed '1475 rpm'
  --power '75 kW'
analyze: every-gearbox-key.yaml --speed '1475 rpm'
  --power '75 kW'
strength: wind-stage.yaml --torque '1000 kN·m' --speed '47.8 rpm' --format json
  --torque '500 kN·m'
  --speed '40 rpm'
  --factors
  --format csv
  --output safeties.json
strength: wind-stage.yaml
  --factors
strength: wind-stage.yaml --torque '1000 kN·m'
  --input '40 rpm'
strength: wind-stage.yaml --speed '47.8 rpm'
  --power '5 MW'
strength: every-gearbox-key.yaml --torque '4 kN·m' --speed '100 rpm'
  --gear 'auxiliary drive'
sheet: every-gearbox-key.yaml --format json
  --set auxiliary
  --format csv
  --output sheets.json
losses: drags.yaml --speed '1475 rpm' --torque '60 N·m' --format json
  --gear slow
  --torque '50 N·m'
  --speed '1400 rpm'
  --format csv
  --output losses.json
vibrate: vibration.yaml --speeds 0rpm..6000rpm/3 --format json
  --gear slow
  --speeds 0rpm..3000rpm/3
  --harmonics 1
  --campbell campbell.svg
  --shapes modes.svg
  --format csv
  --output modes.json
vibrate: vibration.yaml --gear slow --speeds 0rpm..6000rpm/3
  --torsional-campbell torsional.svg
vibrate: every-gearbox-key.yaml
  --set auxiliary
vibrate: two-stages.yaml
  --coupled
vibrate: vibration.yaml --speeds 0rpm..6000rpm/3
  --transmission-error 3um --damping 2%
vibrate: vibration.yaml --speeds 0rpm..6000rpm/3 --transmission-error 3um --damping 2%
  --transmission-error 3um,1um
  --ring-transmission-error 1um
  --damping 3%
  --without-gyroscopic
  --response forces.svg
losses: drags.yaml --speed '1475 rpm' --torque '60 N·m'
  --conductance '20 W/K'
losses: drags.yaml --speed '1475 rpm' --torque '60 N·m' --conductance '20 W/K'
  --conductance '25 W/K'
  --cooler '0.1 kW'
  --allowed-rise '60 K'
losses: drags.yaml --torque '60 N·m'
  --input '1400 rpm'
losses: drags.yaml --speed '1475 rpm'
  --power '10 kW'
  --load-torque '100 N·m'
losses: drags.yaml --gear slow --speeds 500rpm..3000rpm/2 --torques 10N·m..60N·m/2
  --speeds 500rpm..3000rpm/3
  --torques 10N·m..60N·m/3
losses: real-transmissions.yaml --transmission 8HP --speed '100 rpm' --torque '60 N·m'
  --transmission TH400
  --efficiency 97%
losses: II-3 --k1 2.15 --k2 2.35 --speed '100 rpm' --torque '60 N·m'
  --k1 2.5
  --k2 2.5
losses: II-3 --ratio1 1.465 --ratio2 2.56 --speed '100 rpm' --torque '60 N·m'
  --ratio1 1.5
  --ratio2 2.5
simulate: excavator-start.yaml --format json
  --csv samples.csv
  --format csv
  --output start.svg
simulate: every-scenario-key.yaml --output start.png
  --view torques
  --dpi 150
simulate: excavator-start.yaml
  --sweep 'torques[0].constant=20N·m..22N·m'
simulate: excavator-start.yaml --sweep 'torques[0].constant=20N·m..22N·m'
  --steps 3
draw: drags.yaml --view map --gear slow --speeds 100rpm..3000rpm/9 --torques 1N·m..60N·m/9
  --speeds 100rpm..2000rpm/9
  --torques 1N·m..40N·m/9
compare: real-transmissions.yaml ravigneaux.yaml --transmission 8HP
  --transmission TH400
  --efficiency 97%
  --format csv
  --output compared.html
compare: II-3 II-4 --k1 2.15 --k2 2.35
  --k1 2.5
  --k2 2.5
compare: II-3 II-4 --k1 2.15 --k2 2.35 --output compared.html
  --project 'Winch 7'
  --customer 'Mine North'
  --author 'A. Engineer'
  --date '22 November 2026'
  --paper letter
compare: ravigneaux.yaml simpson.yaml
  --input '1475 rpm'
  --torque '500 N·m'
  --speed '1475 rpm'
compare: ravigneaux.yaml simpson.yaml --speed '1475 rpm'
  --power 75kW
compare: II-3 D.T2.B+T1.B.T2 --ratio1 1.465 --ratio2 2.56
  --ratio1 1.5
  --ratio2 2.5
synthesize: --ratios '2.56, 1.465' --format json
  --ratios '2.5, 1.465'
  --tolerance 2%
  --class all-sparse
  --sets 2
  --elements 3
  --engaged 2
  --k 2..4
  --efficiency 95%
  --limit 1
  --links 5
  --open 2
  --format csv
  --output boxes.json
  --order torque
  --objectives torque
  --teeth
  --explain scheme-ii-3.yaml
  --save one.yaml
  --merge none.parquet
  --longest '0.000001 s'
  --shares '1:30%, 2:70%'
  --first-class
synthesize: --ratios '2.7778, -2.2' --sets 2 --elements 2 --engaged 1 --double-planets 1 --format json
  --least-efficiency 99.9%
  --least-reverse-efficiency 99.9%
  --most-circulating 0
synthesize: --ratios '3.5, 2.2, 1.4' --sets 2 --elements 5 --engaged 2 --format json
  --brakes 3
  --clutches 3
  --shifts single
  --skip-shifts single
  --step 1.58..
  --falling-steps
  --slip 1.9
  --link-speed 1.5
  --planet-speed 3
  --drawable
synthesize: --ratios '2.56, 1.465' --sets 2 --elements 2 --engaged 1 --double-planets 1 --format json
  --double-planets 0..1
  --k-double 2..3
synthesize: --ratios '2.56, 1.465' --tolerance 5% --sets 2 --elements 2 --engaged 1 --format json
  --equal-k 2
synthesize: --ratios '2.56, 1.465' --sets 2 --elements 2 --engaged 1 --double-planets 1 --teeth --ring 60..90 --format json
  --k-double 2..3
  --planet 14..
  --planet-count 2
synthesize: --ratios '2.56, 1.465' --teeth --ring 60..100
  --ring 60..90
  --sun 40..
  --planet 14..
  --planet-count 5
  --equal-rings 2
  --equal-suns 2
  --equal-sets 2
  --teeth-aim fewest
  --teeth-limit 2
synthesize: --ratios '3.059, 1.625, 1, 0.696, -2.294' --sets 2 --elements 5 --engaged 2 --class all-sparse --format csv
  --all-gearboxes
synthesize: --ratios '2.56, 1.465' --sets 2 --elements 2 --engaged 1 --output page.html
  --project 'Winch 7'
  --customer 'Mine North'
  --author 'A. Engineer'
  --date '22 November 2026'
  --paper letter
synthesize: --ratios '2.2, 1' --sets 2 --elements 2 --engaged 1 --class all-sparse
  --direct
synthesize: --ratios '2.56, 1.465' --save one.yaml
  --nth 2
synthesize: --ratios '4.714, 3.143' --explain real-transmissions.yaml --transmission 8HP
  --transmission TH400
synthesize: --ratios '2.56, 1.465' --sets 2 --elements 2 --engaged 1 --output boxes
  --shard 1/2
atlas:
  --output .
select: --speeds '0.8 m/s, 3.15 m/s'
  --speeds '1 m/s, 3.15 m/s'
select: --ratios '1.465, 2.56' --format json
  --ratios '1.5, 2.56'
  --all-structures
  --limit 1
  --tolerance 1%
  --brakes as-given
  --signs any
  --k 1.7..4
  --prefer 2..3
  --efficiency 95%
  --least-efficiency 95%
  --link-speed 1.5
  --planet-speed 1.5
  --clutch-slip 1.5
  --circulation 30%
  --same-direction
  --allow-crossing
  --input '1475 rpm'
  --speed '1475 rpm'
  --torque '500 N·m'
  --planets 4
  --mesh-load-factors '1, 1.1, 1.1, 1.2, 1.2, 1.3, 1.4'
  --format csv
  --output select.json
select: --ratios '1.465, 2.56'
  --save winner.yaml
select: --ratios '1.465, 2.56' --save one.yaml
  --nth 2
select: --ratios '1.465, 2.56'
  --teeth --ring 50..60 --limit 2
select: --ratios '1.465, 2.56' --all-structures
  --order size
select: --ratios 2.5 --input '1475 rpm'
  --power '75 kW'
select: --ratios 2.5 --torque '500 N·m'
  --load-factor '2 MPa'
select: --ratios 2.5 --torque '500 N·m' --load-factor '2 MPa' --format json
  --face-width-ratio 0.5
select: --ratios '1.465, 2.56' --teeth --ring 50..60 --sun 18..30 --planet ..24 --limit 2 --torque '500 N·m' --load-factor '2 MPa' --format json
  --ring-diameter '50 mm'
  --least-module '4 mm'
  --greatest-module '1 mm'
select: --ratios '1.465, 2.56' --teeth --ring 50..60 --sun 18..30 --planet ..24 --limit 2 --format json
  --sun 26..30
  --planet 18
  --ring 57..60
  --planet-count 4
select: --ratios 2.5 --output page.html
  --project 'Winch 7'
  --customer 'Mine North'
  --author 'A. Engineer'
  --date '22 November 2026'
  --paper letter
size: travel-drive-duty.yaml --modules '4 mm, 5 mm, 6 mm' --face-widths '30 mm, 40 mm' --planets 3 --format json
  --modules '5 mm, 6 mm'
  --face-widths '40 mm'
  --planets 4
  --centre-distance-step '1 mm'
  --width-ratio 0.3
  --aim tip-alteration
  --tip-thickness 0.4
  --planet-rim 4
  --ring-rim 4
  --bearings mine.csv
  --bearing-rows 1
  --bearing-type rollers
  --no-bearings
  --minimise ring
  --most 1
  --save sized.yaml
  --format csv
  --output size.json
design: --ratios 3.5 --power 75kW --input 1475rpm --modules '2.5 mm, 3 mm' --face-widths '20 mm, 40 mm' --planets 3..6 --sun 40..52 --planet 38..44 --ring 120..140 --tries 3 --format json
  --ratios 3.6
  --input '1400 rpm'
  --power '60 kW'
  --shares '20%, 80%'
  --overload 6
  --ring-offset 1..2
  --bearing-type any
  --tries 1
  --sun 40..50
  --planet 40..42
  --ring 130..140
  --basis wind-stage.yaml
  --factors 'K_A 2'
  --life '5000 h'
  --save box.yaml
  --tolerance 2%
  --k 2..4
  --prefer 2..3
  --efficiency 95%
  --least-efficiency 98%
  --link-speed 1.01
  --planet-speed 0.5
  --clutch-slip 0.5
  --circulation 30%
  --modules '4 mm'
  --face-widths '60 mm'
  --planets 5
  --centre-distance-step '1 mm'
  --width-ratio 0.1
  --aim tip-alteration
  --tip-thickness 0.8
  --planet-rim 2
  --ring-rim 4
  --bearings mine.csv
  --bearing-rows 1
  --no-bearings
  --minimise ring
  --most 1
  --format csv
  --output design.json
design: --ratios 3.5 --power 75kW --input 1475rpm --modules 3mm --face-widths 40mm --planets 3 --sun 40..52 --planet 38..44 --ring 120..140 --no-bearings --format json
  --tooth-design 2
design: --ratios 3.5 --power 75kW --modules 3mm --face-widths 40mm --planets 3 --sun 40..52 --planet 38..44 --ring 120..140 --no-bearings --format json
  --speed 1400rpm
design: --ratios=-3.5 --power 75kW --input 1475rpm --modules 3mm --face-widths 40mm --planets 3 --sun 30..60 --planet 20..50 --ring 90..130 --no-bearings --tries 1 --format json
  --same-direction
design: --ratios '1.465, 2.56' --planet-speed 2.4 --power 75kW --input 1475rpm --modules 3mm --face-widths 40mm --planets 3 --sun 30..60 --planet 20..50 --ring 90..130 --no-bearings --tries 1 --format json
  --may-reverse
design: --ratios '1.465, 2.56' --may-reverse --power 75kW --input 1475rpm --modules 3mm --face-widths 40mm --planets 3 --sun 30..60 --planet 20..50 --ring 90..130 --no-bearings --tries 1 --format json
  --scheme III-1
  --all-structures
  --order size
  --brakes as-given
  --signs any
  --allow-crossing
design: --speeds '0.8 m/s, 2 m/s' --input 1475rpm --torque '480 N·m' --modules '4 mm' --face-widths '30 mm, 60 mm' --planets 3 --sun 18..30 --planet 17..30 --ring 60..90 --no-bearings --tries 2 --output page.html
  --speeds '0.9 m/s, 2 m/s'
  --torque '400 N·m'
  --project 'Winch 7'
  --customer 'Mine North'
  --author 'A. Engineer'
  --date '22 November 2026'
  --paper letter
schemes: II-3 --k1 2.15 --k2 2.35 --format json
  --k1 2
  --k2 2
  --efficiency 95%
  --k 2..3
  --format csv
  --output scheme.json
schemes: II-3 --ratio1 1.465 --ratio2 2.56
  --ratio1 1.5
  --ratio2 2.5
schemes:
  --k 2..3
schemes: II-3
  --k 2..3
machine list:
  --format csv
  --output list.txt
machine speeds: '0.8 m/s, 3.15 m/s'
  --format csv
  --output speeds.txt
machine chain-cutter: --pick-spacing '20 cm' --feed '4 m/min' --chip '2 cm' --format json
  --pick-spacing '25 cm'
  --feed '5 m/min'
  --chip '3 cm'
  --format csv
  --output chain.json
machine chain-cutter: --pick-spacing '20 cm' --feed '4 m/min' --chip '2 cm' --force '4 kN' --other-forces '5 kN, 6.5 kN' --format json
  --force '4.5 kN'
  --other-forces '5 kN'
machine drum: --diameter '1 m' --feed '4 m/min' --chip '2 cm' --picks 2 --format json
  --diameter '1.2 m'
  --feed '5 m/min'
  --chip '3 cm'
  --picks 3
  --format csv
  --output drum.json
machine drum: --diameter '1 m' --feed '4 m/min' --chip '2 cm' --picks 2 --force '4 kN' --other-forces '5 kN, 6.5 kN' --format json
  --force '4.5 kN'
  --other-forces '5 kN'
machine rotor: --boom-radius '20 m' --slewing '0.02 rad/s' --chip-width '0.3 m' --buckets 8 --boom-angle '60 deg' --wheel-radius '3 m' --discharge 0.3 --format json
  --boom-radius '21 m'
  --slewing '0.03 rad/s'
  --chip-width '0.4 m'
  --buckets 9
  --boom-angle '50 deg'
  --wheel-radius '4 m'
  --discharge 0.4
  --format csv
  --output rotor.json
machine rotor: --boom-radius '20 m' --slewing '0.02 rad/s' --chip-width '0.3 m' --buckets 8 --boom-angle '60 deg' --wheel-radius '3 m' --release '70 deg' --chute '95 deg, 110 deg' --radius-ratio 0.6 --format json
  --release '60 deg'
  --chute '95 deg, 105 deg'
  --radius-ratio 0.7
motor: --stator 5 --rotor 3 --z3 60 --zs 10 --module '2 mm'
  --stator 6
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --format json
  --rotor 2
  --z3 60
  --z1 30
  --zs 9
  --module '2.5 mm'
  --l '80 mm'
  --a '30 mm'
  --part 0.4
  --construction
  --width '50 mm'
  --angle '20 deg'
  --pressure-angle '20 deg'
  --addendum 0.8
  --clearance 0.2
  --shift 0.1
  --backlash 0.05
  --fillet 0.12
  --crest tooth
  --svg motor.svg
  --dxf motor.dxf
  --csv motor.csv
  --format csv
  --output motor.json
  --output motor.pdf
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --output motor.png
  --dpi 60
motor: --stator 7 --rotor 5 --z3 84 --zs 11 --module '1 mm'
  --cosine
motor: --stator 8 --rotor 6 --z3 88 --zs 10 --module '2 mm' --cosine
  --second-harmonic 0.002
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --width '50 mm' --pressure '20 MPa' --speed '60 rpm' --format json
  --material 'contact_limit: 2000 MPa, root_limit: 400 MPa'
  --ports 'part: 0.9'
  --friction 0.05..0.1
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --width '50 mm' --pressure '20 MPa' --oil 'viscosity: 46 mm²/s, density: 870 kg/m³' --format json
  --gaps '{ satellites: 10 µm }'
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --width '50 mm' --pressure '20 MPa' --ports 'part: 0.9' --format json
  --oil 'bulk_modulus: 1.4 GPa'
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --width '50 mm' --format json
  --pressure '20 MPa'
  --speed '60 rpm'
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --svg motor.svg --csv motor.csv
  --angle '20 deg'
  --view teeth
  --points 50
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --output page.html
  --project 'Winch 7'
  --customer 'Mine North'
  --author 'A. Engineer'
  --date '22 November 2026'
  --paper letter
motor search: --displacement '250 cm3/rev' --stator 5 --rotor 3 --z3 55 --zs 9..10 --module '2 mm' --places 4 --format json
  --displacement '200 cm3/rev'
  --pressure '15 MPa'
  --speed '60 rpm'
  --module '2.5 mm'
  --outer-diameter '100 mm'
  --ripple '5 %'
  --stator 6
  --rotor 4
  --z3 50..55
  --zs 10
  --divisor common
  --any-teeth
  --pressure-angle '24 deg'
  --addendum 0.8
  --clearance 0.2
  --shift 0.1
  --backlash 0.05
  --fillet 0.12
  --crest tooth
  --flank-ripple '9 %'
  --least-torque '95 %'
  --objectives 'volume, flank-ripple'
  --by ripple
  --places 6
  --resolution '20 %'
  --limit 1
  --svg motor.svg
  --dxf motor.dxf
  --csv motor.csv
  --save motor.yaml
  --format csv
  --output motors.json
  --output motors.pdf
motor search: --displacement '250 cm3/rev' --stator 5 --rotor 3 --z3 55 --zs 9..10 --module '2 mm' --places 4 --output motor.png
  --dpi 60
motor search: --torque '600 N·m' --pressure '20 MPa' --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --places 4 --format json
  --torque '500 N·m'
  --pressure '15 MPa'
motor search: --displacement '250 cm3/rev' --stator 5 --rotor 3 --z3 55 --zs 10 --places 4
  --width '40 mm'
  --width-over-diameter 0.4
motor search: --displacement '250 cm3/rev' --stator 5 --rotor 3 --z3 55 --zs 9..10 --module '2 mm, 2.5 mm' --width '40 mm' --tolerance '10 %' --places 4 --format json
  --tolerance '0.1 %'
motor search: --displacement '250 cm3/rev' --stator 5 --rotor 3 --z3 55 --zs 9..10 --places 4
  --every
motor search: --displacement '250 cm3/rev' --stator 5 --rotor 3 --z3 55 --zs 9..10 --module '2 mm' --places 4 --svg motor.svg --csv motor.csv
  --design 2
  --angle '20 deg'
  --view centrodes
  --points 50
motor forms: --displacement '250 cm3/rev' --stator 6 --rotor 4 --z3 66 --zs 9..10 --module '2 mm' --places 4 --pressure-angle 25deg --addendum 0.8..0.85/2 --shift 0.1..0.2/2 --objectives 'volume, ripple, contact-ratio, radius' --format json
  --displacement '200 cm3/rev'
  --pressure '15 MPa'
  --speed '60 rpm'
  --module '2.5 mm'
  --outer-diameter '120 mm'
  --ripple '6 %'
  --stator 5
  --rotor 5
  --z3 60..66
  --zs 10
  --divisor one
  --families arcs
  --places 5
  --pressure-angle 24deg..26deg/3
  --addendum 0.85
  --shift 0.2
  --clearance 0.2
  --fillet 0.12
  --backlash 0.05
  --crests space
  --contact-ratio 1.2
  --youngs-modulus '200 GPa' --pressure '15 MPa'
  --poissons-ratio 0.25 --pressure '15 MPa'
  --flank-ripple '6 %'
  --least-torque '97 %'
  --objectives volume
  --resolution '20 %'
  --exact
  --by ripple
  --limit 1
  --svg motor.svg
  --dxf motor.dxf
  --csv motor.csv
  --save motor.yaml
  --format csv
  --output motors.json
  --output motors.pdf
motor forms: --displacement '250 cm3/rev' --stator 6 --rotor 4 --z3 66 --zs 10 --module '2 mm' --places 4 --pressure-angle 25deg --addendum 0.8 --shift 0.2 --output motor.png
  --dpi 60
motor forms: --torque '600 N·m' --pressure '20 MPa' --stator 6 --rotor 4 --z3 66 --zs 10 --module '2 mm' --places 4 --pressure-angle 25deg --addendum 0.8..0.85/2 --shift 0.1..0.2/2 --crests space --contact-limit '1500 MPa' --root-limit '400 MPa' --format json
  --torque '500 N·m'
  --pressure '15 MPa'
  --contact-limit '1400 MPa'
  --root-limit '300 MPa'
  --youngs-modulus '200 GPa'
  --poissons-ratio 0.25
  --contact-stress '1100 MPa'
  --root-stress '300 MPa'
  --allowed-pressure '30 MPa'
  --objectives 'volume, allowed-pressure'
  --by contact-stress
motor forms: --displacement '250 cm3/rev' --stator 6 --rotor 4 --z3 66 --zs 10 --places 4 --pressure-angle 25deg --addendum 0.8 --shift 0.2
  --width '40 mm'
  --width-over-diameter 0.4
motor forms: --displacement '250 cm3/rev' --stator 6 --rotor 4 --z3 66 --zs 10 --module '2 mm, 2.5 mm' --width '30 mm' --tolerance '30 %' --places 4 --pressure-angle 25deg --addendum 0.8 --shift 0.2 --format json
  --tolerance '1 %'
motor forms: --displacement '250 cm3/rev' --stator 6 --rotor 4 --z3 66 --zs 9..10 --places 4 --pressure-angle 25deg --addendum 0.8 --shift 0.2
  --every
motor forms: --displacement '250 cm3/rev' --stator 6 --rotor 4 --z3 66 --zs 10 --module '2 mm' --places 4 --pressure-angle 25deg --addendum 0.8..0.85/2 --shift 0.1..0.2/2 --objectives 'volume, ripple, contact-ratio, radius' --svg motor.svg --csv motor.csv
  --design 2
  --angle '20 deg'
  --view centrodes
  --points 50
draw: sized-gearbox.yaml
  --view ladder
draw: real-transmissions.yaml
  --transmission 8HP
draw: II-3 --k1 2.15 --k2 2.35
  --gear 2
  --k1 2.5
  --k2 2.5
draw: II-3 --k1 2.15 --k2 2.35 --gear 2
  --power
draw: sized-gearbox.yaml
  --to-scale
draw: II-3
  --whole
  --same-side
  --title another
  --output drawing.svg
  --output drawing.dxf
  --output drawing.pdf
  --output drawing.png
  --svg drawing.svg
  --dxf drawing.dxf
  --format json
draw: II-3 --output drawing.png
  --dpi 60
draw: II-3 --ratio1 1.465 --ratio2 2.56 --gear 2 --power
  --ratio1 1.5
  --ratio2 2.5
  --efficiency 90%
report: real-transmissions.yaml
  --transmission TH400
report: real-transmissions.yaml --transmission TH400
  --efficiency 97%
report: II-3 --k1 2.15 --k2 2.35
  --k1 2.5
  --k2 2.5
report: II-3 --ratio1 1.465 --ratio2 2.56
  --ratio1 1.5
  --ratio2 2.5
report: scheme-ii-3.yaml
  --torque '500 N·m'
  --speed '1475 rpm'
  --input '1475 rpm'
report: scheme-ii-3.yaml --speed '1475 rpm'
  --power '75 kW'
report: sized-gearbox.yaml
  --to-scale
report: two-stages.yaml --format json
  --speeds 300rpm..2000rpm/12
  --harmonics 1
  --transmission-error 2um
  --ring-transmission-error 1um
  --damping 3%
  --without-gyroscopic
  --coupled
report: minimal-drive.yaml
  --output page.html
  --format json
  --project 'Winch 7'
  --customer 'Mine North'
  --author 'A. Engineer'
  --date '22 November 2026'
  --paper letter
schema: drive
  --output drive.json
completions: bash
  --output here.bash
man:
  --output here.1
";

/// Options without effect in their place, with the correct form.
const REFUSED: &str = "\
analyze: real-transmissions.yaml --speed '100 rpm' | add --transmission
analyze: real-transmissions.yaml --efficiency 97% | add --transmission
strength: wind-stage.yaml --gear only | torque or power
strength: wind-stage.yaml --speed '47.8 rpm' | torque or power
strength: wind-stage.yaml --torque '1000 kN·m' | give it, too
losses: drags.yaml --speed '100 rpm' | a load is due
losses: drags.yaml --speed '100 rpm' --torque '1 N·m' --conductance '0 W/K' | --conductance: conductance 0 W/K: it must be above 0
losses: drags.yaml --speed '100 rpm' --torque '1 N·m' --conductance '9 W/K' --cooler '-1 W' | --cooler: cooler -1 W: it must be 0 or above
losses: drags.yaml --speed '100 rpm' --torque '1 N·m' --conductance '9 W/K' --allowed-rise '0 K' | --allowed-rise: allowed-rise 0 K: it must be above 0
simulate: excavator-start.yaml --view torques | .svg
simulate: excavator-start.yaml --sweep gearbox.sets[0].k=2..3 | no such key
simulate: every-scenario-key.yaml --sweep gearbox.sets[0].planets=2..3 | stays as it is
simulate: every-scenario-key.yaml --sweep elements[C].holding=2s..3s | torque
simulate: every-scenario-key.yaml --sweep elements[X].holding=2N·m..3N·m | no entry
simulate: every-scenario-key.yaml --sweep elements[C].holding=2N·m..3N·m --steps 1 | --steps
simulate: every-scenario-key.yaml --sweep elements[C].holding=2N·m..3N·m -o sweep.svg | tables
simulate: excavator-start.yaml -o start.svg --view temperatures | heat_capacity
draw: drags.yaml --gear slow --speeds 1rpm..2rpm/2 --torques 1N·m..2N·m/2 | only the view map
draw: drags.yaml --gear slow --view map | give both
draw: II-3 --k1 2 --k2 2 --gear 2 --view map --speeds 1rpm..2rpm/2 --torques 1N·m..2N·m/2 | a gearbox's file
compare: real-transmissions.yaml ravigneaux.yaml | name one of
compare: scheme-ii-3.yaml ravigneaux.yaml --transmission 8HP | leave it out
compare: scheme-ii-3.yaml ravigneaux.yaml --k1 2 | the file says how large
compare: ravigneaux.yaml | two gearboxes
analyze: real-transmissions.yaml --progression 1.05 | add --transmission
select: --ratios 2.5 --sun 20 | --teeth
size: travel-drive-duty.yaml --no-bearings --bearings mine.csv | --bearings
size: travel-drive-duty.yaml --centre-distance-step 1e-6mm | a larger step
design: --ratios 2.5 --input 1475rpm | --power
design: --ratios 2.5 --power 75kW --input 1475rpm --paper a4 | .html
design: --ratios 2.5 --power 75kW --input 1475rpm --shares '1, 2, 3' | --shares
design: --ratios 2.5 --power 75kW --input 1475rpm --factors 'K_Q 2' | K_Q
design: --ratios 2.5 --power 75kW --input 1475rpm --overload 0 | above 0
design: --ratios 2.5 --power 75kW --input 1475rpm --scheme IV | catalogue
select: --ratios 2.5 --planet-count 4 | --teeth
select: --ratios 2.5 --face-width-ratio 0.5 | --load-factor
schemes: --efficiency 90% | --k1
schemes: II-3 --efficiency 90% | --k1
teeth: --ratio 6 --nth 2 | --save
teeth: --ratio 6 --aim sliding | --ring-offset
teeth: --ratio 6 --tip-thickness 0.4 | --ring-offset
teeth: --ratio 6 --ring-offset 1 --double-planet | --double-planet
teeth: --ratio 6 --ring-offset 1 --no-undercut | --no-undercut
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --view teeth | --svg
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --points 5 | --csv
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --view forces --svg forces.svg | width and pressure
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --view ports --svg ports.svg | ports as made
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --width 50mm --pressure 20MPa --gaps 'satellites: 10 µm' --view efficiency --svg map.svg | oil.viscosity
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --second-harmonic 0.01 | --cosine
motor: --stator 6 --rotor 4 --z3 66 --zs 10 --module '2 mm' --cosine --second-harmonic 0.1 | between
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --oil 'viscosity: 46 mm²/s' | density
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --oil 'viscosity: 46' | unit
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --oil 'density: 1 kg/m³, viscosity: 1 mm²/s, dynamic_viscosity: 1 mPa·s' | either
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --oil 'thickness: 46 mm²/s' | unknown key
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --material 'contact_limit: 2000 MPa' | root_limit
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --material 'poissons_ratio: 0.7' | 0.5
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --friction 0.1..2 | 1
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --width 50mm --pressure 20MPa --oil 'viscosity: 0.5 mm²/s, density: 1000 kg/m³' --gaps 'satellites: 100 µm' | laminar
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --width 50mm --gaps 'satellites: 3 µm, expansion: 12e-6 /K, temperature_rise: 40 K' | warmer
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --gaps 'satellites: 3 µm, expansion: 12e-6 /K' | temperature_rise
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --ports 'part: 1.5' | 1
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --ports 'dead_volume: 3 mm³, part: 0.9' | width
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --ports 'discharge: 0.7' | part
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --ports 'high: { angle: -15 deg, diameter: 8 mm }' | pitch_radius
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --ports 'high: { angle: 0 deg, diameter: 1 mm, pitch_radius: 100 mm }' | axis
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --ports 'high: { angle: -15 deg, diameter: 8 mm, pitch_radius: 46 mm }, low: { angle: -14 deg, diameter: 8 mm, pitch_radius: 46 mm }' | overlap
motor search: --displacement '250 cm3/rev' --z3 55 --objectives contact-ratio | none of
motor search: --displacement '250 cm3/rev' --z3 55 --objectives 'volume, volume' | twice
motor search: --displacement '250 cm3/rev' --z3 55 --least-torque 1.2 | --least-torque
motor search: --displacement '250 cm3/rev' --z3 55 --flank-ripple 0 | --flank-ripple
motor search: --displacement '250 cm3/rev' --z3 55 --view teeth | --svg
motor search: --displacement '250 cm3/rev' --z3 55 --csv a.csv --angle '5 deg' | --svg
motor search: --displacement '250 cm3/rev' --z3 55 --design 2 | --csv
motor search: --displacement '250 cm3/rev' --z3 55 --module '2 mm' --tolerance 5% | --width
motor forms: --displacement '250 cm3/rev' --z3 66 --contact-limit '1500 MPa' | --root-limit
motor forms: --displacement '250 cm3/rev' --z3 66 --root-limit '400 MPa' | --contact-limit
motor forms: --displacement '250 cm3/rev' --z3 66 --contact-stress '900 MPa' | --pressure
motor forms: --displacement '250 cm3/rev' --z3 66 --root-stress '300 MPa' | --pressure
motor forms: --displacement '250 cm3/rev' --z3 66 --allowed-pressure '30 MPa' | --contact-limit
motor forms: --displacement '250 cm3/rev' --z3 66 --by allowed-pressure | --contact-limit
motor forms: --displacement '250 cm3/rev' --z3 66 --objectives root-stress | --pressure
motor forms: --displacement '250 cm3/rev' --z3 66 --exact --resolution 1% | --resolution
motor forms: --displacement '250 cm3/rev' --z3 66 --view teeth | --svg
motor forms: --displacement '250 cm3/rev' --z3 66 --csv a.csv --angle '5 deg' | --svg
motor forms: --displacement '250 cm3/rev' --z3 66 --design 2 | --csv
motor forms: --displacement '250 cm3/rev' --z3 66 --module '2 mm' --tolerance 5% | --width
draw: sized-gearbox.yaml --efficiency 97% | --power
drive: minimal-drive.yaml --project 'Winch 7' | .html
select: --ratios 2.5 --paper a4 | .html
synthesize: --ratios '2.56, 1.465' --date today --output boxes.txt | .html
synthesize: --ratios '2.56, 1.465' --step 1 | --step: a step between two of the ratios is 1.7128 to 1.7827
synthesize: --ratios '4, 2, 0.5' --falling-steps | --falling-steps: a step between the ratios is at least 3.9208
motor: --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --author me | .html
report: minimal-drive.yaml --customer me --format json | .html
report: sized-gearbox.yaml --to-scale --format json | pictures
report: minimal-drive.yaml --to-scale | drive
report: self-crossing.yaml --to-scale | crossing
report: minimal-drive.yaml --coupled | drive
report: scheme-ii-3.yaml --harmonics 2 | `vibration` of a set
vibrate: vibration.yaml --without-gyroscopic | a transmission error and speeds of the input
";

/// Bearings of one's own.
const MINE: &str = "designation,rolling,d_mm,D_mm,B_mm,C_kN\nmine,rollers,20,40,15,80\n";

/// A command line, and what is added to it.
struct Line {
    command: &'static str,
    words: Vec<String>,
    added: Vec<Vec<String>>,
}

impl Line {
    /// The command and its words.
    fn new(text: &'static str) -> Self {
        let (command, line) = text.split_once(':').unwrap();
        Self { command, words: words(line), added: vec![] }
    }
}

fn tried() -> Vec<Line> {
    let mut all: Vec<Line> = vec![];
    for text in TRIED.lines() {
        match text.strip_prefix("  ") {
            Some(added) => all.last_mut().unwrap().added.push(words(added)),
            None => all.push(Line::new(text)),
        }
    }
    all
}

/// Results of a call: its exit code, its answer, the files it wrote.
type Left = (Option<i32>, String, BTreeMap<String, Vec<u8>>);

fn left(command: &str, args: &[String]) -> (Left, String) {
    let folder = tempfile::tempdir().unwrap();
    for name in args.iter().filter(|arg| arg.ends_with(".yaml")) {
        let example = examples().join(name);
        if example.exists() {
            fs::copy(example, folder.path().join(name)).unwrap();
        }
    }
    if args.iter().any(|arg| arg == "mine.csv") {
        fs::write(folder.path().join("mine.csv"), MINE).unwrap();
    }
    let line: Vec<&str> = command.split(' ').chain(args.iter().map(String::as_str)).collect();
    let done = output(folder.path(), &line);
    let read = |path: &Path| fs::read(path).unwrap();
    let files = fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().path());
    let files =
        files.map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), read(&path))).collect();
    ((done.status.code(), text(&done.stdout), files), text(&done.stderr))
}

/// A line with other options in place of its own.
fn with(line: &[String], more: &[String]) -> Vec<String> {
    let mut all = vec![];
    let mut words = line.iter();
    while let Some(word) = words.next() {
        if word.starts_with("--") && more.contains(word) {
            words.next();
        } else {
            all.push(word.clone());
        }
    }
    all.extend_from_slice(more);
    all
}

/// The options of each command, as completions know them.
fn all_options() -> BTreeMap<String, BTreeSet<String>> {
    let (left, _) = left("completions", &words("bash"));
    let lines: Vec<&str> = left.1.lines().map(str::trim).collect();
    let mut all = BTreeMap::new();
    for pair in lines.windows(2) {
        let Some(path) = pair[0].strip_prefix("epicyclic__subcmd__").and_then(|path| path.strip_suffix(')'))
        else {
            continue;
        };
        let Some(opts) = pair[1].strip_prefix("opts=\"") else { continue };
        let options: BTreeSet<String> = opts
            .trim_end_matches('"')
            .split(' ')
            .filter(|word| word.starts_with("--") && *word != "--help")
            .map(str::to_owned)
            .collect();
        // A hyphen in a name is written as a level of its own.
        let name = path.replace("chain__subcmd__cutter", "chain-cutter").replace("__subcmd__", " ");
        if !options.is_empty() {
            all.insert(name, options);
        }
    }
    all
}

fn check(commands: &[&str]) {
    let mut faults = vec![];
    for Line { command, words, added } in tried().iter().filter(|line| commands.contains(&line.command)) {
        let before = left(command, words).0;
        for more in added {
            let (after, told) = left(command, &with(words, more));
            // Nothing found is an answer too; `--z1` is a check, and nothing but a refusal shows it; all
            // parts together with `--merge` give the same, and only parts that are not all show it;
            // `--longest` refuses.
            if before == after {
                faults.push(format!("{command} {words:?}: {more:?} changes nothing: {told}"));
            } else if after.0 > Some(1) && !["--z1", "--merge", "--longest"].contains(&more[0].as_str()) {
                faults.push(format!("{command} {words:?}: {more:?} ends with {:?}: {told}", after.0));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_option_of_gearboxes_changes_the_answer() {
    check(&[
        "teeth",
        "drive",
        "analyze",
        "strength",
        "sheet",
        "size",
        "losses",
        "simulate",
        "vibrate",
        "compare",
        "schemes",
        "draw",
        "report",
        "schema",
        "completions",
        "man",
    ]);
    check(&["synthesize", "atlas"]);
}

#[test]
fn every_option_of_machines_changes_the_answer() {
    check(&["machine list", "machine speeds", "machine chain-cutter", "machine drum", "machine rotor"]);
}

#[test]
fn every_option_of_a_choice_changes_the_answer() {
    check(&["select"]);
}

#[test]
fn every_option_of_a_design_changes_the_answer() {
    check(&["design"]);
}

#[test]
fn every_option_of_motors_changes_the_answer() {
    check(&["motor", "motor search", "motor forms"]);
}

#[test]
fn no_option_is_left_out() {
    let mut all: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for line in tried() {
        let options = line.added.iter().map(|more| more[0].clone());
        all.entry(line.command.to_owned()).or_default().extend(options);
    }
    // It does not end: the tests of the server try them.
    all.insert("serve".to_owned(), ["--app", "--no-browser", "--port"].map(str::to_owned).into());
    assert_eq!(all, all_options());
}

#[test]
fn an_option_that_would_change_nothing_says_what_it_needs() {
    for row in REFUSED.lines() {
        let (line, wanted) = row.split_once(" | ").unwrap();
        let Line { command, words, .. } = Line::new(line);
        let ((code, answer, _), told) = left(command, &words);
        let is_refused = answer.is_empty() || answer.contains("\"answer\": \"error\"");
        assert!(code == Some(2) && is_refused && told.contains(wanted), "{row}: {code:?} {told}");
    }
}
