#pragma once
#include <atomic>

namespace pantin {

/// From now on a script that does not come back within a moment is stopped, whatever its limit, and its error leaves as
/// Interrupted. May be called by a signal's handler.
void interrupt_scripts() noexcept;
bool scripts_interrupted() noexcept;
/// Whether that moment has passed.
bool scripts_must_end() noexcept;
/// Scripts may take their time again.
void allow_scripts() noexcept;

/// Ends the program where nothing else can stop a scene, and says why. Null, as in a program that only holds scenes: it goes on.
inline std::atomic<void (*)(const char* why)> last_resort{nullptr};

}  // namespace pantin
