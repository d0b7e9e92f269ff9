// Failed checks show numbers with enough digits to tell 1.04e-10 from 1e-10.
#include <catch2/catch.hpp>

namespace {

const bool digits_set = [] {
  Catch::StringMaker<double>::precision = 16;
  return true;
}();

}  // namespace
