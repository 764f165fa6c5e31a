// Written by the test `keywords` of `mstmm-codegen` from `src/language.md`: change the tables there.

/// `Hz`: hertz, 1/s, a frequency; for angular velocities write `rev/s` or `rad/s`.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum Hz {}

/// `J`: joule, N m, an energy.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum J {}

/// `MHz`: megahertz, 10⁶ Hz.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum MHz {}

/// `MJ`: megajoule, 10⁶ J.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum MJ {}

/// `MN`: meganewton, 10⁶ N.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum MN {}

/// `MPa`: megapascal, 10⁶ Pa.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum MPa {}

/// `MW`: megawatt, 10⁶ W.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum MW {}

/// `Mg`: megagram, 10⁶ g.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum Mg {}

/// `Mm`: megametre, 10⁶ m.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum Mm {}

/// `Mrad`: megaradian, 10⁶ rad.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum Mrad {}

/// `Ms`: megasecond, 10⁶ s.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum Ms {}

/// `N`: newton, kg m/s², a force.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum N {}

/// `Pa`: pascal, N/m², a pressure.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum Pa {}

/// `W`: watt, J/s, a power.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum W {}

/// `cHz`: centihertz, 10⁻² Hz.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum cHz {}

/// `cJ`: centijoule, 10⁻² J.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum cJ {}

/// `cN`: centinewton, 10⁻² N.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum cN {}

/// `cPa`: centipascal, 10⁻² Pa.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum cPa {}

/// `cW`: centiwatt, 10⁻² W.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum cW {}

/// `cg`: centigram, 10⁻² g.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum cg {}

/// `cm`: centimetre, 10⁻² m.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum cm {}

/// `crad`: centiradian, 10⁻² rad.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum crad {}

/// `cs`: centisecond, 10⁻² s.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum cs {}

/// `dHz`: decihertz, 10⁻¹ Hz.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum dHz {}

/// `dJ`: decijoule, 10⁻¹ J.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum dJ {}

/// `dN`: decinewton, 10⁻¹ N.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum dN {}

/// `dPa`: decipascal, 10⁻¹ Pa.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum dPa {}

/// `dW`: deciwatt, 10⁻¹ W.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum dW {}

/// `deg`: degree, π/180 rad.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum deg {}

/// `dg`: decigram, 10⁻¹ g.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum dg {}

/// `dm`: decimetre, 10⁻¹ m.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum dm {}

/// `drad`: deciradian, 10⁻¹ rad.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum drad {}

/// `ds`: decisecond, 10⁻¹ s.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum ds {}

/// `g`: gram, 10⁻³ kg.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum g {}

/// `h`: hour, 3600 s.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum h {}

/// `kHz`: kilohertz, 10³ Hz.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum kHz {}

/// `kJ`: kilojoule, 10³ J.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum kJ {}

/// `kN`: kilonewton, 10³ N.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum kN {}

/// `kPa`: kilopascal, 10³ Pa.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum kPa {}

/// `kW`: kilowatt, 10³ W.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum kW {}

/// `kg`: kilogram, 10³ g.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum kg {}

/// `km`: kilometre, 10³ m.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum km {}

/// `krad`: kiloradian, 10³ rad.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum krad {}

/// `ks`: kilosecond, 10³ s.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum ks {}

/// `m`: metre, the SI unit of length.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum m {}

/// `mHz`: millihertz, 10⁻³ Hz.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum mHz {}

/// `mJ`: millijoule, 10⁻³ J.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum mJ {}

/// `mN`: millinewton, 10⁻³ N.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum mN {}

/// `mPa`: millipascal, 10⁻³ Pa.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum mPa {}

/// `mW`: milliwatt, 10⁻³ W.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum mW {}

/// `mg`: milligram, 10⁻³ g.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum mg {}

/// `min`: minute, 60 s.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum min {}

/// `mm`: millimetre, 10⁻³ m.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum mm {}

/// `mrad`: milliradian, 10⁻³ rad.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum mrad {}

/// `ms`: millisecond, 10⁻³ s.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum ms {}

/// `nHz`: nanohertz, 10⁻⁹ Hz.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum nHz {}

/// `nJ`: nanojoule, 10⁻⁹ J.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum nJ {}

/// `nN`: nanonewton, 10⁻⁹ N.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum nN {}

/// `nPa`: nanopascal, 10⁻⁹ Pa.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum nPa {}

/// `nW`: nanowatt, 10⁻⁹ W.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum nW {}

/// `ng`: nanogram, 10⁻⁹ g.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum ng {}

/// `nm`: nanometre, 10⁻⁹ m.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum nm {}

/// `nrad`: nanoradian, 10⁻⁹ rad.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum nrad {}

/// `ns`: nanosecond, 10⁻⁹ s.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum ns {}

/// `rad`: radian, the SI unit of angles, a plain number.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum rad {}

/// `rev`: revolution, 2π rad.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum rev {}

/// `rpm`: revolution per minute, 2π/60 rad/s.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum rpm {}

/// `s`: second, the SI unit of time.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum s {}

/// `t`: tonne, 1000 kg.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
pub enum t {}

/// `uHz`: microhertz, 10⁻⁶ Hz.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum uHz {}

/// `uJ`: microjoule, 10⁻⁶ J.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum uJ {}

/// `uN`: micronewton, 10⁻⁶ N.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum uN {}

/// `uPa`: micropascal, 10⁻⁶ Pa.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum uPa {}

/// `uW`: microwatt, 10⁻⁶ W.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum uW {}

/// `ug`: microgram, 10⁻⁶ g.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum ug {}

/// `um`: micrometre, 10⁻⁶ m.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum um {}

/// `urad`: microradian, 10⁻⁶ rad.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum urad {}

/// `us`: microsecond, 10⁻⁶ s.
///
/// See [numbers and units](crate::mstmm_chain#numbers-and-units).
#[doc(hidden)]
pub enum us {}
