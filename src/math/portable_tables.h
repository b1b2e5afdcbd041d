// Written by tools/portable_tables.py; edit that, not this.
// clang-format off
#pragma once

#include <cstdint>

namespace rt::portable::tables {

/// pi/2 as an unevaluated sum.
inline constexpr double kHalfPiHi = 0x1.921fb54442d18p+0;
inline constexpr double kHalfPiLo = 0x1.1a62633145c07p-54;

/// pi as an unevaluated sum.
inline constexpr double kPiHi = 0x1.921fb54442d18p+1;
inline constexpr double kPiLo = 0x1.1a62633145c07p-53;

/// pi/2 in three parts for the reduction; the first has 33 bits, so that n times it is exact
/// for |n| < 2^20 (Cody and Waite, Software Manual for the Elementary Functions, 1980).
inline constexpr double kReduce1 = 0x1.921fb54400000p+0;
inline constexpr double kReduce2 = 0x1.0b4611a626331p-34;
inline constexpr double kReduce3 = 0x1.1701b839a2520p-88;

/// 2/pi and ln 2 rounded to double.
inline constexpr double kTwoOverPiNearest = 0x1.45f306dc9c883p-1;
inline constexpr double kLn2 = 0x1.62e42fefa39efp-1;

/// pi/180 as an unevaluated sum.
inline constexpr double kDegreeHi = 0x1.1df46a2529d39p-6;
inline constexpr double kDegreeLo = 0x1.5c1d8becdd291p-62;

/// ln 2; the first part has 41 bits on the grid of kLogHi, so that k ln 2 is exact.
inline constexpr double kLn2Hi = 0x1.62e42fefa3000p-1;
inline constexpr double kLn2Lo = 0x1.3de6af278ece6p-42;

/// ln 2 / 128 as an unevaluated sum.
inline constexpr double kLn2By128Hi = 0x1.62e42fefa39efp-8;
inline constexpr double kLn2By128Lo = 0x1.abc9e3b39803fp-63;

/// 1 / ln 2 as an unevaluated sum.
inline constexpr double kLog2EHi = 0x1.71547652b82fep+0;
inline constexpr double kLog2ELo = 0x1.777d0ffda0d24p-56;

/// 1 / ln 10 as an unevaluated sum.
inline constexpr double kLog10EHi = 0x1.bcb7b1526e50ep-2;
inline constexpr double kLog10ELo = 0x1.95355baaafad3p-57;

/// The bits of 2/pi, 64 a word; the word before the point, which is 0, comes first.
inline constexpr std::uint64_t kTwoOverPi[] = {
    0x0000000000000000, 0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041,
    0xfe5163abdebbc561, 0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e,
    0xe88235f52ebb4484, 0xe99c7026b45f7e41, 0x3991d639835339f4, 0x9c845f8bbdf9283b,
    0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab,
    0xf0cfbc209af4361d,
};

/// sin(r) = r + r^3 S(r^2) for |r| <= pi/4: relative error 2^-57.3.
inline constexpr double kSin[] = {
    -0x1.5555555555555p-3, 0x1.1111111111110p-7, -0x1.a01a01a019938p-13,
    0x1.71de3a5460952p-19, -0x1.ae645412c4787p-26, 0x1.61217f0ac7f98p-33,
    -0x1.ab17d3985bccep-41,
};

/// cos(r) = 1 - r^2/2 + r^4 C(r^2) for |r| <= pi/4: absolute error 2^-60.0.
inline constexpr double kCos[] = {
    0x1.5555555555555p-5, -0x1.6c16c16c16c16p-10, 0x1.a01a01a019d0ap-16,
    -0x1.27e4fb7712d61p-22, 0x1.1eed8deb97423p-29, -0x1.9394ba0c332d9p-37,
    0x1.ab785aa02d659p-45,
};

/// exp(r) = 1 + r + r^2 E(r) for |r| <= ln 2 / 256: absolute error 2^-63.7.
inline constexpr double kExp[] = {
    0x1.fffffffffff58p-2, 0x1.5555555555525p-3, 0x1.55555accc1ca7p-5,
    0x1.11111430bcc06p-7,
};

/// log(1 + r) = r - r^2/2 + r^3 L(r) for -2^-8 <= r <= 2^-7: relative error 2^-69.6.
inline constexpr double kLog[] = {
    0x1.5555555555555p-2, -0x1.ffffffffffff4p-3, 0x1.9999999997b7bp-3,
    -0x1.55555557e04cep-3, 0x1.24924d791ddf4p-3, -0x1.fffdf4e1589c2p-4,
    0x1.c1929b9b4d704p-4,
};

/// atan(t) = t + t^3 A(t^2) for |t| <= 1/128: relative error 2^-69.6.
inline constexpr double kAtan[] = {
    -0x1.5555555555555p-2, 0x1.99999999998dfp-3, -0x1.2492491606fedp-3,
    0x1.c710cf1488c7dp-4,
};

/// asin(s) = s + s^3 P(s^2) for |s| <= 1/2: relative error 2^-58.6.
inline constexpr double kAsin[] = {
    0x1.5555555555555p-3, 0x1.3333333333388p-4, 0x1.6db6db6dac1e0p-5,
    0x1.f1c71c7a52ba3p-6, 0x1.6e8ba123e494cp-6, 0x1.1c4efce23019fp-6,
    0x1.c990ad3d8fdcap-7, 0x1.7b027ee1dd585p-7, 0x1.3b49de7121487p-7,
    0x1.31622469ce5adp-7, 0x1.8f193743418ffp-9, 0x1.406192d124629p-6,
    -0x1.3b416bb7d9257p-6, 0x1.e529c6fce9bb4p-6,
};

/// 2^(j/128) rounded to double, j = 0 .. 127 (Tang, ACM TOMS 15, 1989).
inline constexpr double kExpTable[] = {
    0x1p+0, 0x1.0163da9fb3335p+0, 0x1.02c9a3e778061p+0,
    0x1.04315e86e7f85p+0, 0x1.059b0d3158574p+0, 0x1.0706b29ddf6dep+0,
    0x1.0874518759bc8p+0, 0x1.09e3ecac6f383p+0, 0x1.0b5586cf9890fp+0,
    0x1.0cc922b7247f7p+0, 0x1.0e3ec32d3d1a2p+0, 0x1.0fb66affed31bp+0,
    0x1.11301d0125b51p+0, 0x1.12abdc06c31ccp+0, 0x1.1429aaea92de0p+0,
    0x1.15a98c8a58e51p+0, 0x1.172b83c7d517bp+0, 0x1.18af9388c8deap+0,
    0x1.1a35beb6fcb75p+0, 0x1.1bbe084045cd4p+0, 0x1.1d4873168b9aap+0,
    0x1.1ed5022fcd91dp+0, 0x1.2063b88628cd6p+0, 0x1.21f49917ddc96p+0,
    0x1.2387a6e756238p+0, 0x1.251ce4fb2a63fp+0, 0x1.26b4565e27cddp+0,
    0x1.284dfe1f56381p+0, 0x1.29e9df51fdee1p+0, 0x1.2b87fd0dad990p+0,
    0x1.2d285a6e4030bp+0, 0x1.2ecafa93e2f56p+0, 0x1.306fe0a31b715p+0,
    0x1.32170fc4cd831p+0, 0x1.33c08b26416ffp+0, 0x1.356c55f929ff1p+0,
    0x1.371a7373aa9cbp+0, 0x1.38cae6d05d866p+0, 0x1.3a7db34e59ff7p+0,
    0x1.3c32dc313a8e5p+0, 0x1.3dea64c123422p+0, 0x1.3fa4504ac801cp+0,
    0x1.4160a21f72e2ap+0, 0x1.431f5d950a897p+0, 0x1.44e086061892dp+0,
    0x1.46a41ed1d0057p+0, 0x1.486a2b5c13cd0p+0, 0x1.4a32af0d7d3dep+0,
    0x1.4bfdad5362a27p+0, 0x1.4dcb299fddd0dp+0, 0x1.4f9b2769d2ca7p+0,
    0x1.516daa2cf6642p+0, 0x1.5342b569d4f82p+0, 0x1.551a4ca5d920fp+0,
    0x1.56f4736b527dap+0, 0x1.58d12d497c7fdp+0, 0x1.5ab07dd485429p+0,
    0x1.5c9268a5946b7p+0, 0x1.5e76f15ad2148p+0, 0x1.605e1b976dc09p+0,
    0x1.6247eb03a5585p+0, 0x1.6434634ccc320p+0, 0x1.6623882552225p+0,
    0x1.68155d44ca973p+0, 0x1.6a09e667f3bcdp+0, 0x1.6c012750bdabfp+0,
    0x1.6dfb23c651a2fp+0, 0x1.6ff7df9519484p+0, 0x1.71f75e8ec5f74p+0,
    0x1.73f9a48a58174p+0, 0x1.75feb564267c9p+0, 0x1.780694fde5d3fp+0,
    0x1.7a11473eb0187p+0, 0x1.7c1ed0130c132p+0, 0x1.7e2f336cf4e62p+0,
    0x1.80427543e1a12p+0, 0x1.82589994cce13p+0, 0x1.8471a4623c7adp+0,
    0x1.868d99b4492edp+0, 0x1.88ac7d98a6699p+0, 0x1.8ace5422aa0dbp+0,
    0x1.8cf3216b5448cp+0, 0x1.8f1ae99157736p+0, 0x1.9145b0b91ffc6p+0,
    0x1.93737b0cdc5e5p+0, 0x1.95a44cbc8520fp+0, 0x1.97d829fde4e50p+0,
    0x1.9a0f170ca07bap+0, 0x1.9c49182a3f090p+0, 0x1.9e86319e32323p+0,
    0x1.a0c667b5de565p+0, 0x1.a309bec4a2d33p+0, 0x1.a5503b23e255dp+0,
    0x1.a799e1330b358p+0, 0x1.a9e6b5579fdbfp+0, 0x1.ac36bbfd3f37ap+0,
    0x1.ae89f995ad3adp+0, 0x1.b0e07298db666p+0, 0x1.b33a2b84f15fbp+0,
    0x1.b59728de5593ap+0, 0x1.b7f76f2fb5e47p+0, 0x1.ba5b030a1064ap+0,
    0x1.bcc1e904bc1d2p+0, 0x1.bf2c25bd71e09p+0, 0x1.c199bdd85529cp+0,
    0x1.c40ab5fffd07ap+0, 0x1.c67f12e57d14bp+0, 0x1.c8f6d9406e7b5p+0,
    0x1.cb720dcef9069p+0, 0x1.cdf0b555dc3fap+0, 0x1.d072d4a07897cp+0,
    0x1.d2f87080d89f2p+0, 0x1.d5818dcfba487p+0, 0x1.d80e316c98398p+0,
    0x1.da9e603db3285p+0, 0x1.dd321f301b460p+0, 0x1.dfc97337b9b5fp+0,
    0x1.e264614f5a129p+0, 0x1.e502ee78b3ff6p+0, 0x1.e7a51fbc74c83p+0,
    0x1.ea4afa2a490dap+0, 0x1.ecf482d8e67f1p+0, 0x1.efa1bee615a27p+0,
    0x1.f252b376bba97p+0, 0x1.f50765b6e4540p+0, 0x1.f7bfdad9cbe14p+0,
    0x1.fa7c1819e90d8p+0, 0x1.fd3c22b8f71f1p+0,
};

/// What the rounding left, relative: 2^(j/128) / kExpTable[j] - 1.
inline constexpr double kExpTail[] = {
    0.0, 0x1.b3b4f1a88bf6ep-54, -0x1.160139cd8dc5dp-56,
    -0x1.05e7a108766d1p-54, 0x1.cd2523567f613p-55, -0x1.bce8023f98efap-55,
    0x1.0f74e61e6c861p-57, 0x1.0a3e45b33d399p-54, 0x1.79aa65d837b6dp-54,
    0x1.eb51a92fdeffcp-55, 0x1.ebe3d702f9cd1p-60, -0x1.a033489906e0bp-57,
    -0x1.556522a2fbd0ep-54, -0x1.080ef8c4eea55p-58, -0x1.1c923b9d5f416p-54,
    0x1.0d3e3e95c55afp-55, -0x1.01b15eaa59348p-55, -0x1.f1ff055de323dp-55,
    0x1.b898c3f1353bfp-55, -0x1.6d99c7611eb26p-54, 0x1.aecf73e3a2f60p-54,
    -0x1.fe782cb86389dp-55, 0x1.a6f4144a6c38dp-55, 0x1.07a05b0e4047dp-55,
    0x1.68efde3a8a894p-54, 0x1.75e18f274487dp-55, 0x1.0472b981fe7f2p-55,
    -0x1.6b87b3f71085ep-54, 0x1.2f7e16d09ab31p-55, -0x1.d219b1a6fbffap-60,
    0x1.b3782720c0ab4p-55, 0x1.e149289cecb8fp-57, 0x1.34d754db0abb6p-55,
    0x1.64201e2ac744cp-55, 0x1.fdd395dd3f84ap-55, -0x1.6a3803b8e5b04p-55,
    -0x1.24aedcc4b5068p-54, -0x1.907f81b512d8ep-54, -0x1.1d1e83e9436d2p-56,
    -0x1.91919b3ce1b15p-54, 0x1.59f48a72a4c6dp-55, -0x1.312607a28698ap-54,
    -0x1.8a78f4817895bp-58, -0x1.c2c9b67499a1bp-56, 0x1.363ed60c2ac11p-59,
    0x1.666093b0664efp-54, 0x1.ecce1daa10379p-57, 0x1.3ff8e3f0f1230p-54,
    0x1.690cebb7aafb0p-56, 0x1.31dbdeb54e077p-54, -0x1.f94340071a38ep-55,
    -0x1.7deccdc93a349p-55, -0x1.8dec6bd0f385fp-56, -0x1.61246ec7b5cf6p-55,
    0x1.3350518fdd78ep-54, 0x1.b98b72f8a9b05p-56, 0x1.063e1e21c5409p-54,
    0x1.4c7855019c6eap-60, 0x1.432e62b64c035p-54, -0x1.ce44a6199769fp-55,
    -0x1.c33c53bef4da8p-55, -0x1.45378892be9aep-55, -0x1.3cedd78565858p-54,
    0x1.710aa807e1964p-58, -0x1.3b3efbf5e2228p-54, -0x1.a12ad8734b982p-57,
    -0x1.367efb86da9eep-57, -0x1.0dc3d54e08851p-55, -0x1.81f647e5a3ecfp-56,
    -0x1.6ee4ac08b7db0p-55, -0x1.619321e55e68ap-55, 0x1.09ccb5e09d4d3p-54,
    -0x1.b32dcb94da51dp-56, 0x1.4ecfd5467c06bp-54, 0x1.5ebe1abd66c55p-57,
    -0x1.8a1c52fb3cf42p-55, -0x1.369b6f13b3734p-54, -0x1.05e843a19ff1ep-55,
    -0x1.4d450d872576ep-54, 0x1.0ad675b0e8a00p-54, 0x1.db72fc1f0eab4p-55,
    -0x1.5b6609cc5e7ffp-57, 0x1.bf68359f35f44p-56, -0x1.3091fa71e3d83p-54,
    -0x1.da9b88b6c1e29p-58, -0x1.c23f97c90b959p-57, -0x1.2434322f4f9aap-54,
    -0x1.5ca6cd7668e4bp-55, 0x1.1affc2b91ce27p-56, 0x1.dd235e10a73bbp-57,
    -0x1.7c50422622263p-55, 0x1.b1c86e3e231d5p-55, -0x1.1bbd1d3bcbb15p-54,
    0x1.0cc319cee31d2p-54, 0x1.469846e735ab3p-55, -0x1.2dfcd978e9db4p-55,
    0x1.c1a7792cb3387p-55, -0x1.07b8f4ad1d9fap-54, -0x1.5c3d956dcaebap-58,
    -0x1.0a40e3da6f640p-54, -0x1.8d6f438ad9334p-57, -0x1.1eee26b588a35p-54,
    0x1.4ffd70a5fddcdp-56, -0x1.1bdfbfa9298acp-54, 0x1.36eae30af0cb3p-56,
    0x1.ee3325c9ffd94p-55, 0x1.4e08fd10959acp-55, 0x1.3cdaf384e1a67p-57,
    0x1.76b2c6c921968p-57, -0x1.08a1883ccb5d2p-55, -0x1.fad5d3ffffa6fp-55,
    -0x1.00dae3875a949p-54, 0x1.4a385a63d07a7p-56, -0x1.2919e2040220fp-55,
    0x1.e5a50d5c192acp-55, 0x1.43a59ac016b4bp-55, -0x1.2d52107b43e1fp-55,
    -0x1.92ab93b470dc9p-55, 0x1.4b604603a88d3p-56, 0x1.3c5ec519d7271p-55,
    -0x1.ff7128fd391f0p-55, -0x1.dae98e223747dp-55, 0x1.ec3bc41aa2008p-55,
    0x1.42b94c3a9eb32p-55, 0x1.a64a931d185eep-55, -0x1.e37bae43be3edp-55,
    0x1.7893b4d91cd9dp-56, 0x1.305c14160cc89p-58,
};

/// 1/c, c the middle of the cell; 1 in both cells that touch 1.
inline constexpr double kLogInverse[] = {
    0x1.734f0c541fe8dp+0, 0x1.713786d9c7c09p+0, 0x1.6f26016f26017p+0,
    0x1.6d1a62681c861p+0, 0x1.6b1490aa31a3dp+0, 0x1.691473a88d0c0p+0,
    0x1.6719f3601671ap+0, 0x1.6524f853b4aa3p+0, 0x1.63356b88ac0dep+0,
    0x1.614b36831ae94p+0, 0x1.5f66434292dfcp+0, 0x1.5d867c3ece2a5p+0,
    0x1.5babcc647fa91p+0, 0x1.59d61f123ccaap+0, 0x1.5805601580560p+0,
    0x1.56397ba7c52e2p+0, 0x1.54725e6bb82fep+0, 0x1.52aff56a8054bp+0,
    0x1.50f22e111c4c5p+0, 0x1.4f38f62dd4c9bp+0, 0x1.4d843bedc2c4cp+0,
    0x1.4bd3edda68fe1p+0, 0x1.4a27fad76014ap+0, 0x1.4880522014880p+0,
    0x1.46dce34596066p+0, 0x1.453d9e2c776cap+0, 0x1.43a2730abee4dp+0,
    0x1.420b5265e5951p+0, 0x1.40782d10e6566p+0, 0x1.3ee8f42a5af07p+0,
    0x1.3d5d991aa75c6p+0, 0x1.3bd60d9232955p+0, 0x1.3a524387ac822p+0,
    0x1.38d22d366088ep+0, 0x1.3755bd1c945eep+0, 0x1.35dce5f9f2af8p+0,
    0x1.34679ace01346p+0, 0x1.32f5ced6a1dfap+0, 0x1.3187758e9ebb6p+0,
    0x1.301c82ac40260p+0, 0x1.2eb4ea1fed14bp+0, 0x1.2d50a012d50a0p+0,
    0x1.2bef98e5a3711p+0, 0x1.2a91c92f3c105p+0, 0x1.293725bb804a5p+0,
    0x1.27dfa38a1ce4dp+0, 0x1.268b37cd60127p+0, 0x1.2539d7e9177b2p+0,
    0x1.23eb79717605bp+0, 0x1.22a0122a0122ap+0, 0x1.21579804855e6p+0,
    0x1.2012012012012p+0, 0x1.1ecf43c7fb84cp+0, 0x1.1d8f5672e4abdp+0,
    0x1.1c522fc1ce059p+0, 0x1.1b17c67f2bae3p+0, 0x1.19e0119e0119ep+0,
    0x1.18ab083902bdbp+0, 0x1.1778a191bd684p+0, 0x1.1648d50fc3201p+0,
    0x1.151b9a3fdd5c9p+0, 0x1.13f0e8d344724p+0, 0x1.12c8b89edc0acp+0,
    0x1.11a3019a74826p+0, 0x1.107fbbe011080p+0, 0x1.0f5edfab325a2p+0,
    0x1.0e40655826011p+0, 0x1.0d24456359e3ap+0, 0x1.0c0a7868b4171p+0,
    0x1.0af2f722eecb5p+0, 0x1.09ddba6af8360p+0, 0x1.08cabb37565e2p+0,
    0x1.07b9f29b8eae2p+0, 0x1.06ab59c7912fbp+0, 0x1.059eea0727586p+0,
    0x1.04949cc1664c5p+0, 0x1.038c6b78247fcp+0, 0x1.02864fc7729e9p+0,
    0x1.0182436517a37p+0, 0x1p+0, 0x1p+0,
    0x1.fa11caa01fa12p-1, 0x1.f6310aca0dbb5p-1, 0x1.f25f644230ab5p-1,
    0x1.ee9c7f8458e02p-1, 0x1.eae807aba01ebp-1, 0x1.e741aa59750e4p-1,
    0x1.e3a9179dc1a73p-1, 0x1.e01e01e01e01ep-1, 0x1.dca01dca01dcap-1,
    0x1.d92f2231e7f8ap-1, 0x1.d5cac807572b2p-1, 0x1.d272ca3fc5b1ap-1,
    0x1.cf26e5c44bfc6p-1, 0x1.cbe6d9601cbe7p-1, 0x1.c8b265afb8a42p-1,
    0x1.c5894d10d4986p-1, 0x1.c26b5392ea01cp-1, 0x1.bf583ee868d8bp-1,
    0x1.bc4fd65883e7bp-1, 0x1.b951e2b18ff23p-1, 0x1.b65e2e3beee05p-1,
    0x1.b37484ad806cep-1, 0x1.b094b31d922a4p-1, 0x1.adbe87f94905ep-1,
    0x1.aaf1d2f87ebfdp-1, 0x1.a82e65130e159p-1, 0x1.a574107688a4ap-1,
    0x1.a2c2a87c51ca0p-1, 0x1.a01a01a01a01ap-1, 0x1.9d79f176b682dp-1,
    0x1.9ae24ea5510dap-1, 0x1.9852f0d8ec0ffp-1, 0x1.95cbb0be377aep-1,
    0x1.934c67f9b2ce6p-1, 0x1.90d4f120190d5p-1, 0x1.8e6527af1373fp-1,
    0x1.8bfce8062ff3ap-1, 0x1.899c0f601899cp-1, 0x1.87427bcc092b9p-1,
    0x1.84f00c2780614p-1, 0x1.82a4a0182a4a0p-1, 0x1.8060180601806p-1,
    0x1.7e225515a4f1dp-1, 0x1.7beb3922e017cp-1, 0x1.79baa6bb6398bp-1,
    0x1.77908119ac60dp-1, 0x1.756cac201756dp-1,
};

/// log(c) to a multiple of 2^-42, so that k ln 2 + log(c) is exact.
inline constexpr double kLogHi[] = {
    -0x1.7cc7f7db47000p-2, -0x1.76feecb947000p-2, -0x1.713e33a46a000p-2,
    -0x1.6b85b4cffa000p-2, -0x1.65d558d4ce000p-2, -0x1.602d08af09000p-2,
    -0x1.5a8cadbbee000p-2, -0x1.54f431b7be000p-2, -0x1.4f637ebbaa000p-2,
    -0x1.49da7f3bcc000p-2, -0x1.44591e053a000p-2, -0x1.3edf463c17000p-2,
    -0x1.396ce359bc000p-2, -0x1.3401e12aed000p-2, -0x1.2e9e2bce12000p-2,
    -0x1.2941afb187000p-2, -0x1.23ec5991ec000p-2, -0x1.1e9e16788a000p-2,
    -0x1.1956d3b9bc000p-2, -0x1.14167ef367000p-2, -0x1.0edd060b78000p-2,
    -0x1.09aa572e6c000p-2, -0x1.047e60cde8000p-2, -0x1.feb2233ea0000p-3,
    -0x1.f474b134e0000p-3, -0x1.ea4449f04a000p-3, -0x1.e020cc6236000p-3,
    -0x1.d60a17f904000p-3, -0x1.cc000c9db4000p-3, -0x1.c2028ab180000p-3,
    -0x1.b811730b82000p-3, -0x1.ae2ca6f672000p-3, -0x1.a454082e6a000p-3,
    -0x1.9a8778deba000p-3, -0x1.90c6db9fcc000p-3, -0x1.871213750e000p-3,
    -0x1.7d6903caf6000p-3, -0x1.73cb9074fe000p-3, -0x1.6a399dabbe000p-3,
    -0x1.60b3100b0a000p-3, -0x1.5737cc9018000p-3, -0x1.4dc7b897bc000p-3,
    -0x1.4462b9dc9c000p-3, -0x1.3b08b67580000p-3, -0x1.31b994d3a4000p-3,
    -0x1.28753bc11a000p-3, -0x1.1f3b925f26000p-3, -0x1.160c8024b2000p-3,
    -0x1.0ce7ecdccc000p-3, -0x1.03cdc0a51e000p-3, -0x1.f57bc7d900000p-4,
    -0x1.e3707ee304000p-4, -0x1.d179788218000p-4, -0x1.bf968769fc000p-4,
    -0x1.adc77ee5b0000p-4, -0x1.9c0c32d4d4000p-4, -0x1.8a6477a91c000p-4,
    -0x1.78d02263d8000p-4, -0x1.674f089364000p-4, -0x1.55e10050e0000p-4,
    -0x1.4485e03dbc000p-4, -0x1.333d7f8184000p-4, -0x1.2207b5c784000p-4,
    -0x1.10e45b3cb0000p-4, -0x1.ffa6911ab8000p-5, -0x1.dda8adc680000p-5,
    -0x1.bbcebfc690000p-5, -0x1.9a187b5740000p-5, -0x1.788595a358000p-5,
    -0x1.5715c4c040000p-5, -0x1.35c8bfaa10000p-5, -0x1.149e3e4008000p-5,
    -0x1.e72bf28140000p-6, -0x1.a55f548c60000p-6, -0x1.63d6178690000p-6,
    -0x1.228fb1fea0000p-6, -0x1.c317384c80000p-7, -0x1.41929f9680000p-7,
    -0x1.8121214580000p-8, 0.0, 0.0,
    0x1.7dc475f820000p-7, 0x1.3cea443470000p-6, 0x1.b9fc027b00000p-6,
    0x1.1b0d989240000p-5, 0x1.58a5bafc90000p-5, 0x1.95c830ec90000p-5,
    0x1.d276b8adb0000p-5, 0x1.0759835990000p-4, 0x1.253f62f0a0000p-4,
    0x1.42edcbea64000p-4, 0x1.60658a9374000p-4, 0x1.7da766d7b0000p-4,
    0x1.9ab4246204000p-4, 0x1.b78c82bb10000p-4, 0x1.d4313d66cc000p-4,
    0x1.f0a30c0118000p-4, 0x1.0671512ca6000p-3, 0x1.1478584674000p-3,
    0x1.2266f190a6000p-3, 0x1.303d718e48000p-3, 0x1.3dfc2b0ecc000p-3,
    0x1.4ba36f39a6000p-3, 0x1.59338d9982000p-3, 0x1.66acd4272a000p-3,
    0x1.740f8f5404000p-3, 0x1.815c0a1436000p-3, 0x1.8e928de886000p-3,
    0x1.9bb362e7e0000p-3, 0x1.a8becfc882000p-3, 0x1.b5b519e8fc000p-3,
    0x1.c2968558c2000p-3, 0x1.cf6354e09c000p-3, 0x1.dc1bca0abe000p-3,
    0x1.e8c0252aa6000p-3, 0x1.f550a564b8000p-3, 0x1.00e6c45ad5000p-2,
    0x1.071b85fcd6000p-2, 0x1.0d46b579ab000p-2, 0x1.136870293b000p-2,
    0x1.1980d2dd42000p-2, 0x1.1f8ff9e48a000p-2, 0x1.2596010df7000p-2,
    0x1.2b9303ab8a000p-2, 0x1.31871c9544000p-2, 0x1.3772662bfe000p-2,
    0x1.3d54fa5c1f000p-2, 0x1.432ef2a04f000p-2,
};

/// The rest of log(c).
inline constexpr double kLogLo[] = {
    0x1.7c61c38023cdcp-44, -0x1.75b19c9852c57p-46, -0x1.7bc12617e9472p-46,
    -0x1.fe6e50d372503p-45, -0x1.558fd2dc5bdc0p-51, -0x1.ec69176df3f65p-46,
    0x1.7be9b0af7ecf8p-48, -0x1.a7ef4c0910952p-46, 0x1.fc168cb3124b9p-44,
    -0x1.07f134daf4b9ap-44, 0x1.6de5892923d88p-47, 0x1.f08e4297f2c3fp-44,
    0x1.5a15c5663663dp-47, 0x1.17f03556e291dp-44, -0x1.42e0c128d1dc2p-45,
    0x1.20fd2b730e28bp-44, 0x1.6dbf448a2e522p-44, 0x1.82ba6d3c8b65ep-44,
    -0x1.7c8873ad1aa14p-45, -0x1.e11ef824daaf5p-44, -0x1.044b52d8435f5p-47,
    -0x1.b51f9e1734342p-44, -0x1.dba110d397f3cp-45, -0x1.f2c18de00938bp-45,
    0x1.bb019f1df7b5ep-44, -0x1.5e90663732a36p-44, 0x1.52df0adb91424p-45,
    0x1.5d8a86fc20d39p-44, 0x1.d6e985d57aff9p-46, 0x1.92a3ee55c7ac6p-45,
    -0x1.e9e283b9cd768p-46, -0x1.7af2dae54f550p-44, -0x1.60587c81f7171p-44,
    -0x1.4744a3efec390p-44, 0x1.929357718d7cap-46, -0x1.3272b42f9af75p-44,
    0x1.4cd0b17c301d7p-45, 0x1.d66b90d0005a6p-44, 0x1.8f944e66a15a6p-44,
    0x1.71756c988f814p-44, -0x1.9b97fa6b887f6p-44, -0x1.c71b60ae1ff0fp-47,
    0x1.84830a711b062p-44, 0x1.ab150f29320fbp-44, -0x1.f0b76e3a50810p-44,
    -0x1.74346359302e6p-44, 0x1.5ddee9b083633p-46, -0x1.ebfb2a9009e3dp-45,
    -0x1.4588dabff5447p-46, -0x1.81a8cf169fc5cp-44, -0x1.76a2c9ea8b04ep-46,
    -0x1.0f664e6766abdp-45, -0x1.36193b5efbeedp-44, -0x1.42f7c8d824283p-45,
    0x1.5718a09c31904p-44, 0x1.ab3589e838668p-44, -0x1.c28b0af9bd6dfp-44,
    -0x1.6bb9794b69fb7p-47, -0x1.a78394c9d3302p-44, -0x1.c13340c53c72ep-47,
    -0x1.fb04ee8d26ab7p-44, 0x1.6c6b6a81b8848p-49, -0x1.4a16cfc10c7bfp-44,
    0x1.7d699284a3465p-44, -0x1.3088c98381a8fp-45, 0x1.1a74c64d9e42fp-45,
    0x1.7b8e68c317c2ap-46, 0x1.0bf7e4ec4d90dp-44, 0x1.06fed083b3a4cp-46,
    0x1.88f55dfc47628p-44, -0x1.8347d5ef9eb35p-44, 0x1.2b99a9a4168fdp-44,
    0x1.8cb3149774d47p-45, 0x1.dec609f2d03c9p-45, -0x1.77b7389596542p-47,
    -0x1.70513284991fep-45, 0x1.41e53fcefb9fep-44, -0x1.9862755d01368p-46,
    -0x1.ac06382973f27p-46, 0.0, 0.0,
    -0x1.eb2d45b5da1f5p-44, -0x1.69f0c32d6a40bp-44, -0x1.b99990ae6922ap-44,
    -0x1.340ae9ae889bbp-44, -0x1.b2d039570ad39p-45, -0x1.c0dc297c5feb8p-45,
    0x1.6ac83c78a64b0p-46, -0x1.b8ebfe4b59987p-44, 0x1.41708fb69a701p-44,
    0x1.bb6aeea7c9acdp-46, 0x1.0c3c1dee9c4f8p-44, 0x1.2d0344480c89bp-44,
    -0x1.8a46826787061p-45, -0x1.2604fbc3987e7p-44, -0x1.9452379135713p-45,
    -0x1.d5bce83368e91p-44, -0x1.a44979cdc0a3dp-45, 0x1.560651027c750p-46,
    -0x1.4cddab840e7f6p-45, -0x1.5b6b5ce3ecb05p-50, 0x1.8a9ba62b8c13fp-45,
    -0x1.436fbb3f219e5p-44, 0x1.0ac68b7555d4ap-48, 0x1.aa1cdbfc6c785p-44,
    -0x1.0b9a499018aa1p-44, -0x1.02dbaf9201ce8p-44, 0x1.a8224b13d72d5p-44,
    -0x1.1eca8a1ce0ffcp-45, 0x1.e3195cf21b9cfp-44, -0x1.4b4eaec011f31p-44,
    -0x1.cf7d3dee38a40p-45, 0x1.775339a07d55bp-45, 0x1.8f671a628ccc6p-44,
    -0x1.6803b80e8e6ffp-45, -0x1.32513a09202fep-45, 0x1.cd88d52e01203p-50,
    -0x1.bcb7ba3e01a11p-44, 0x1.d2d21f640e1e6p-44, -0x1.d3f3c99d67123p-44,
    0x1.b75fa7a361c9ap-45, 0x1.7966c040cbe77p-45, 0x1.8e7cc224ea3e3p-44,
    -0x1.6d8c2d6bfb0a5p-45, 0x1.84c2b94cecfd9p-46, -0x1.e8f7eac53b023p-44,
    0x1.c4054d9a395e3p-44, -0x1.fb4c1931715adp-44,
};

/// atan(i/64), i = 0 .. 64.
inline constexpr double kAtanHi[] = {
    0.0, 0x1.fff555bbb729bp-7, 0x1.ffd55bba97625p-6,
    0x1.7fb818430da2ap-5, 0x1.ff55bb72cfdeap-5, 0x1.3f59f0e7c559dp-4,
    0x1.7ee182602f10fp-4, 0x1.be39ebe6f07c3p-4, 0x1.fd5ba9aac2f6ep-4,
    0x1.1e1fafb043727p-3, 0x1.3d6eee8c6626cp-3, 0x1.5c9811e3ec26ap-3,
    0x1.7b97b4bce5b02p-3, 0x1.9a6a8e96c8626p-3, 0x1.b90d7529260a2p-3,
    0x1.d77d5df205736p-3, 0x1.f5b75f92c80ddp-3, 0x1.09dc597d86362p-2,
    0x1.18bf5a30bf178p-2, 0x1.278372057ef46p-2, 0x1.362773707ebccp-2,
    0x1.44aa436c2af0ap-2, 0x1.530ad9951cd4ap-2, 0x1.614840309cfe2p-2,
    0x1.6f61941e4def1p-2, 0x1.7d5604b63b3f7p-2, 0x1.8b24d394a1b25p-2,
    0x1.98cd5454d6b18p-2, 0x1.a64eec3cc23fdp-2, 0x1.b3a911da65c6cp-2,
    0x1.c0db4c94ec9f0p-2, 0x1.cde53432c1351p-2, 0x1.dac670561bb4fp-2,
    0x1.e77eb7f175a34p-2, 0x1.f40dd0b541418p-2, 0x1.0039c73c1a40cp-1,
    0x1.0657e94db30d0p-1, 0x1.0c6145b5b43dap-1, 0x1.1255d9bfbd2a9p-1,
    0x1.1835a88be7c13p-1, 0x1.1e00babdefeb4p-1, 0x1.23b71e2cc9e6ap-1,
    0x1.2958e59308e31p-1, 0x1.2ee628406cbcap-1, 0x1.345f01cce37bbp-1,
    0x1.39c391cd4171ap-1, 0x1.3f13fb89e96f4p-1, 0x1.445065b795b56p-1,
    0x1.4978fa3269ee1p-1, 0x1.4e8de5bb6ec04p-1, 0x1.538f57b89061fp-1,
    0x1.587d81f732fbbp-1, 0x1.5d58987169b18p-1, 0x1.6220d115d7b8ep-1,
    0x1.66d663923e087p-1, 0x1.6b798920b3d99p-1, 0x1.700a7c5784634p-1,
    0x1.748978fba8e0fp-1, 0x1.78f6bbd5d315ep-1, 0x1.7d528289fa093p-1,
    0x1.819d0b7158a4dp-1, 0x1.85d69576cc2c5p-1, 0x1.89ff5ff57f1f8p-1,
    0x1.8e17aa99cc05ep-1, 0x1.921fb54442d18p-1,
};

/// The rest of atan(i/64).
inline constexpr double kAtanLo[] = {
    0.0, -0x1.220c39d4dff50p-61, -0x1.5ec431444912cp-60,
    -0x1.86ef8f794f105p-63, -0x1.c934d86d23f1dp-60, 0x1.ac4ce285df847p-58,
    -0x1.cfb654c0c3d98p-58, 0x1.f7b8f29a05987p-58, -0x1.cd37686760c17p-59,
    -0x1.b485914dacf8cp-59, 0x1.61a3b0ce9281bp-57, -0x1.054ab2c010f3dp-58,
    0x1.347b0b4f881cap-58, 0x1.cf601e7b4348ep-59, 0x1.17b10d2e0e5abp-61,
    0x1.c648d1534597ep-57, 0x1.8ab6e3cf7afbdp-57, 0x1.62e47390cb865p-56,
    0x1.30ca4748b1bf9p-57, -0x1.077cdd36dfc81p-56, -0x1.963a544b672d8p-57,
    -0x1.5d5e43c55b3bap-56, -0x1.2566480884082p-57, -0x1.a725715711f00p-56,
    -0x1.c63aae6f6e918p-56, 0x1.69c885c2b249ap-56, 0x1.b6d0ba3748fa8p-56,
    0x1.9e6c988fd0a77p-56, -0x1.24dec1b50b7ffp-56, 0x1.ae187b1ca5040p-56,
    -0x1.cc1ce70934c34p-56, -0x1.a2cfa4418f1adp-56, 0x1.a2b7f222f65e2p-56,
    0x1.0e53dc1bf3435p-56, -0x1.a3992dc382a23p-57, -0x1.b32c949c9d593p-55,
    -0x1.d5b495f6349e6p-56, 0x1.974fa13b5404fp-58, -0x1.2bdaee1c0ee35p-58,
    0x1.c621cec00c301p-55, -0x1.928df287a668fp-58, 0x1.c421c9f38224ep-57,
    -0x1.09e73b0c6c087p-56, 0x1.c5d5e9ff0cf8dp-55, 0x1.1021137c71102p-55,
    -0x1.2304331d8bf46p-55, 0x1.ecf8b492644f0p-56, -0x1.f76d0163f79c8p-56,
    0x1.2419a87f2a458p-56, 0x1.4a33dbeb3796cp-55, -0x1.1bb74abda520cp-55,
    -0x1.5e5c9d8c5a950p-56, 0x1.0028e4bc5e7cap-57, -0x1.2b785350ee8c1p-57,
    -0x1.6ea6febe8bbbap-56, -0x1.a80386188c50ep-55, -0x1.8c34d25aadef6p-56,
    0x1.7b2a6165884a1p-59, 0x1.406a089803740p-55, 0x1.560821e2f3aa9p-55,
    -0x1.bf76229d3b917p-56, 0x1.6b66e7fc8b8c3p-57, -0x1.55b9a5e177a1bp-55,
    -0x1.ec182ab042f61p-56, 0x1.1a62633145c07p-55,
};

}  // namespace rt::portable::tables
