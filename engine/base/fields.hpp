#pragma once
// The fields of a plain struct as a list, so that what goes through all of them forgets none: not one that is added later
// either. C++20 has no such list; it is found by how many initialisers the struct takes.
#include <cstddef>
#include <type_traits>
#include <utility>

namespace pantin {

// clang-format off
#define PANTIN_NONE_1 {}
#define PANTIN_FIELD_1 f1
#define PANTIN_NONE_2 PANTIN_NONE_1, {}
#define PANTIN_NONE_3 PANTIN_NONE_2, {}
#define PANTIN_NONE_4 PANTIN_NONE_3, {}
#define PANTIN_NONE_5 PANTIN_NONE_4, {}
#define PANTIN_NONE_6 PANTIN_NONE_5, {}
#define PANTIN_NONE_7 PANTIN_NONE_6, {}
#define PANTIN_NONE_8 PANTIN_NONE_7, {}
#define PANTIN_NONE_9 PANTIN_NONE_8, {}
#define PANTIN_NONE_10 PANTIN_NONE_9, {}
#define PANTIN_NONE_11 PANTIN_NONE_10, {}
#define PANTIN_NONE_12 PANTIN_NONE_11, {}
#define PANTIN_NONE_13 PANTIN_NONE_12, {}
#define PANTIN_NONE_14 PANTIN_NONE_13, {}
#define PANTIN_NONE_15 PANTIN_NONE_14, {}
#define PANTIN_NONE_16 PANTIN_NONE_15, {}
#define PANTIN_NONE_17 PANTIN_NONE_16, {}
#define PANTIN_NONE_18 PANTIN_NONE_17, {}
#define PANTIN_NONE_19 PANTIN_NONE_18, {}
#define PANTIN_NONE_20 PANTIN_NONE_19, {}
#define PANTIN_NONE_21 PANTIN_NONE_20, {}
#define PANTIN_NONE_22 PANTIN_NONE_21, {}
#define PANTIN_NONE_23 PANTIN_NONE_22, {}
#define PANTIN_NONE_24 PANTIN_NONE_23, {}
#define PANTIN_NONE_25 PANTIN_NONE_24, {}
#define PANTIN_NONE_26 PANTIN_NONE_25, {}
#define PANTIN_NONE_27 PANTIN_NONE_26, {}
#define PANTIN_NONE_28 PANTIN_NONE_27, {}
#define PANTIN_NONE_29 PANTIN_NONE_28, {}
#define PANTIN_NONE_30 PANTIN_NONE_29, {}
#define PANTIN_NONE_31 PANTIN_NONE_30, {}
#define PANTIN_NONE_32 PANTIN_NONE_31, {}
#define PANTIN_NONE_33 PANTIN_NONE_32, {}
#define PANTIN_NONE_34 PANTIN_NONE_33, {}
#define PANTIN_NONE_35 PANTIN_NONE_34, {}
#define PANTIN_NONE_36 PANTIN_NONE_35, {}
#define PANTIN_NONE_37 PANTIN_NONE_36, {}
#define PANTIN_NONE_38 PANTIN_NONE_37, {}
#define PANTIN_NONE_39 PANTIN_NONE_38, {}
#define PANTIN_NONE_40 PANTIN_NONE_39, {}
#define PANTIN_NONE_41 PANTIN_NONE_40, {}
#define PANTIN_NONE_42 PANTIN_NONE_41, {}
#define PANTIN_NONE_43 PANTIN_NONE_42, {}
#define PANTIN_NONE_44 PANTIN_NONE_43, {}
#define PANTIN_NONE_45 PANTIN_NONE_44, {}
#define PANTIN_NONE_46 PANTIN_NONE_45, {}
#define PANTIN_NONE_47 PANTIN_NONE_46, {}
#define PANTIN_NONE_48 PANTIN_NONE_47, {}
#define PANTIN_NONE_49 PANTIN_NONE_48, {}
#define PANTIN_NONE_50 PANTIN_NONE_49, {}
#define PANTIN_NONE_51 PANTIN_NONE_50, {}
#define PANTIN_NONE_52 PANTIN_NONE_51, {}
#define PANTIN_NONE_53 PANTIN_NONE_52, {}
#define PANTIN_NONE_54 PANTIN_NONE_53, {}
#define PANTIN_NONE_55 PANTIN_NONE_54, {}
#define PANTIN_NONE_56 PANTIN_NONE_55, {}
#define PANTIN_NONE_57 PANTIN_NONE_56, {}
#define PANTIN_NONE_58 PANTIN_NONE_57, {}
#define PANTIN_NONE_59 PANTIN_NONE_58, {}
#define PANTIN_NONE_60 PANTIN_NONE_59, {}
#define PANTIN_NONE_61 PANTIN_NONE_60, {}
#define PANTIN_NONE_62 PANTIN_NONE_61, {}
#define PANTIN_NONE_63 PANTIN_NONE_62, {}
#define PANTIN_NONE_64 PANTIN_NONE_63, {}
#define PANTIN_NONE_65 PANTIN_NONE_64, {}
#define PANTIN_NONE_66 PANTIN_NONE_65, {}
#define PANTIN_NONE_67 PANTIN_NONE_66, {}
#define PANTIN_NONE_68 PANTIN_NONE_67, {}
#define PANTIN_NONE_69 PANTIN_NONE_68, {}
#define PANTIN_NONE_70 PANTIN_NONE_69, {}
#define PANTIN_NONE_71 PANTIN_NONE_70, {}
#define PANTIN_NONE_72 PANTIN_NONE_71, {}
#define PANTIN_NONE_73 PANTIN_NONE_72, {}
#define PANTIN_NONE_74 PANTIN_NONE_73, {}
#define PANTIN_NONE_75 PANTIN_NONE_74, {}
#define PANTIN_NONE_76 PANTIN_NONE_75, {}
#define PANTIN_NONE_77 PANTIN_NONE_76, {}
#define PANTIN_NONE_78 PANTIN_NONE_77, {}
#define PANTIN_NONE_79 PANTIN_NONE_78, {}
#define PANTIN_NONE_80 PANTIN_NONE_79, {}
#define PANTIN_FIELD_2 PANTIN_FIELD_1, f2
#define PANTIN_FIELD_3 PANTIN_FIELD_2, f3
#define PANTIN_FIELD_4 PANTIN_FIELD_3, f4
#define PANTIN_FIELD_5 PANTIN_FIELD_4, f5
#define PANTIN_FIELD_6 PANTIN_FIELD_5, f6
#define PANTIN_FIELD_7 PANTIN_FIELD_6, f7
#define PANTIN_FIELD_8 PANTIN_FIELD_7, f8
#define PANTIN_FIELD_9 PANTIN_FIELD_8, f9
#define PANTIN_FIELD_10 PANTIN_FIELD_9, f10
#define PANTIN_FIELD_11 PANTIN_FIELD_10, f11
#define PANTIN_FIELD_12 PANTIN_FIELD_11, f12
#define PANTIN_FIELD_13 PANTIN_FIELD_12, f13
#define PANTIN_FIELD_14 PANTIN_FIELD_13, f14
#define PANTIN_FIELD_15 PANTIN_FIELD_14, f15
#define PANTIN_FIELD_16 PANTIN_FIELD_15, f16
#define PANTIN_FIELD_17 PANTIN_FIELD_16, f17
#define PANTIN_FIELD_18 PANTIN_FIELD_17, f18
#define PANTIN_FIELD_19 PANTIN_FIELD_18, f19
#define PANTIN_FIELD_20 PANTIN_FIELD_19, f20
#define PANTIN_FIELD_21 PANTIN_FIELD_20, f21
#define PANTIN_FIELD_22 PANTIN_FIELD_21, f22
#define PANTIN_FIELD_23 PANTIN_FIELD_22, f23
#define PANTIN_FIELD_24 PANTIN_FIELD_23, f24
#define PANTIN_FIELD_25 PANTIN_FIELD_24, f25
#define PANTIN_FIELD_26 PANTIN_FIELD_25, f26
#define PANTIN_FIELD_27 PANTIN_FIELD_26, f27
#define PANTIN_FIELD_28 PANTIN_FIELD_27, f28
#define PANTIN_FIELD_29 PANTIN_FIELD_28, f29
#define PANTIN_FIELD_30 PANTIN_FIELD_29, f30
#define PANTIN_FIELD_31 PANTIN_FIELD_30, f31
#define PANTIN_FIELD_32 PANTIN_FIELD_31, f32
#define PANTIN_FIELD_33 PANTIN_FIELD_32, f33
#define PANTIN_FIELD_34 PANTIN_FIELD_33, f34
#define PANTIN_FIELD_35 PANTIN_FIELD_34, f35
#define PANTIN_FIELD_36 PANTIN_FIELD_35, f36
#define PANTIN_FIELD_37 PANTIN_FIELD_36, f37
#define PANTIN_FIELD_38 PANTIN_FIELD_37, f38
#define PANTIN_FIELD_39 PANTIN_FIELD_38, f39
#define PANTIN_FIELD_40 PANTIN_FIELD_39, f40
#define PANTIN_FIELD_41 PANTIN_FIELD_40, f41
#define PANTIN_FIELD_42 PANTIN_FIELD_41, f42
#define PANTIN_FIELD_43 PANTIN_FIELD_42, f43
#define PANTIN_FIELD_44 PANTIN_FIELD_43, f44
#define PANTIN_FIELD_45 PANTIN_FIELD_44, f45
#define PANTIN_FIELD_46 PANTIN_FIELD_45, f46
#define PANTIN_FIELD_47 PANTIN_FIELD_46, f47
#define PANTIN_FIELD_48 PANTIN_FIELD_47, f48
#define PANTIN_FIELD_49 PANTIN_FIELD_48, f49
#define PANTIN_FIELD_50 PANTIN_FIELD_49, f50
#define PANTIN_FIELD_51 PANTIN_FIELD_50, f51
#define PANTIN_FIELD_52 PANTIN_FIELD_51, f52
#define PANTIN_FIELD_53 PANTIN_FIELD_52, f53
#define PANTIN_FIELD_54 PANTIN_FIELD_53, f54
#define PANTIN_FIELD_55 PANTIN_FIELD_54, f55
#define PANTIN_FIELD_56 PANTIN_FIELD_55, f56
#define PANTIN_FIELD_57 PANTIN_FIELD_56, f57
#define PANTIN_FIELD_58 PANTIN_FIELD_57, f58
#define PANTIN_FIELD_59 PANTIN_FIELD_58, f59
#define PANTIN_FIELD_60 PANTIN_FIELD_59, f60
#define PANTIN_FIELD_61 PANTIN_FIELD_60, f61
#define PANTIN_FIELD_62 PANTIN_FIELD_61, f62
#define PANTIN_FIELD_63 PANTIN_FIELD_62, f63
#define PANTIN_FIELD_64 PANTIN_FIELD_63, f64
#define PANTIN_FIELD_65 PANTIN_FIELD_64, f65
#define PANTIN_FIELD_66 PANTIN_FIELD_65, f66
#define PANTIN_FIELD_67 PANTIN_FIELD_66, f67
#define PANTIN_FIELD_68 PANTIN_FIELD_67, f68
#define PANTIN_FIELD_69 PANTIN_FIELD_68, f69
#define PANTIN_FIELD_70 PANTIN_FIELD_69, f70
#define PANTIN_FIELD_71 PANTIN_FIELD_70, f71
#define PANTIN_FIELD_72 PANTIN_FIELD_71, f72
#define PANTIN_FIELD_73 PANTIN_FIELD_72, f73
#define PANTIN_FIELD_74 PANTIN_FIELD_73, f74
#define PANTIN_FIELD_75 PANTIN_FIELD_74, f75
#define PANTIN_FIELD_76 PANTIN_FIELD_75, f76
#define PANTIN_FIELD_77 PANTIN_FIELD_76, f77
#define PANTIN_FIELD_78 PANTIN_FIELD_77, f78
#define PANTIN_FIELD_79 PANTIN_FIELD_78, f79
#define PANTIN_FIELD_80 PANTIN_FIELD_79, f80
#define PANTIN_EACH_COUNT(use) \
  use(80) use(79) use(78) use(77) use(76) use(75) use(74) use(73) use(72) use(71) use(70) use(69) use(68) use(67) \
  use(66) use(65) use(64) use(63) use(62) use(61) use(60) use(59) use(58) use(57) use(56) use(55) use(54) use(53) \
  use(52) use(51) use(50) use(49) use(48) use(47) use(46) use(45) use(44) use(43) use(42) use(41) use(40) use(39) \
  use(38) use(37) use(36) use(35) use(34) use(33) use(32) use(31) use(30) use(29) use(28) use(27) use(26) use(25) \
  use(24) use(23) use(22) use(21) use(20) use(19) use(18) use(17) use(16) use(15) use(14) use(13) use(12) use(11) \
  use(10) use(9) use(8) use(7) use(6) use(5) use(4) use(3) use(2) use(1)
// clang-format on

/// How many fields a plain struct has; 0 where it has none, or more than 80.
template <class T>
constexpr std::size_t count_fields() {
#define PANTIN_COUNT(n)                           \
  if constexpr (requires { T{PANTIN_NONE_##n}; }) \
    return n;                                     \
  else
  PANTIN_EACH_COUNT(PANTIN_COUNT)
#undef PANTIN_COUNT
  return 0;
}

/// Calls use(field, …) with all fields of a plain struct that has no base.
template <class T, class Use>
void with_fields(T& value, Use&& use) {
  constexpr std::size_t count = count_fields<std::remove_const_t<T>>();
#define PANTIN_USE(n)                         \
  if constexpr (count == n) {                 \
    auto& [PANTIN_FIELD_##n] = value;         \
    std::forward<Use>(use)(PANTIN_FIELD_##n); \
  } else
  PANTIN_EACH_COUNT(PANTIN_USE) static_assert(std::is_empty_v<T>, "it has more fields than with_fields knows");
#undef PANTIN_USE
}

}  // namespace pantin
