#include "base/functions.hpp"

// Lua's operator ^ calls the C library's pow, whose bits depend on the processor. This one takes its place in the
// program; it is alone in its file, so that the linker takes it out of the archive before it comes to the C library.
extern "C" double pow(double x, double y);
extern "C" double pow(double x, double y) { return pantin::functions::pow(x, y); }
