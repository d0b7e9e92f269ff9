#include "player/report.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "player/confine.hpp"
#include "player/home.hpp"
#include "player/interrupt.hpp"
#include "player/machine.hpp"
#include "player/message.hpp"
#include "player/output.hpp"
#include "scene/printable.hpp"

namespace pantin::player {
namespace {

/// A line on standard error that moves, where that is a terminal.
class StatusLine {
 public:
  ~StatusLine() {
    if (terminal_) std::cerr << "\r\033[K" << std::flush;
  }
  void show(const std::string& what, double part) const {
    if (terminal_)
      std::cerr << "\r\033[K" << std::min(100, static_cast<int>(100 * part)) << " %  " << what << std::flush;
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) != 0;
};

}  // namespace

int report(const RunOptions& options, const std::string& prefix, const std::string& home) {
  const Interrupt interrupt;
  const std::string scene = find_scene(options.scene, home);
  const std::string start = prefix.empty() ? scene_name(scene) + "-report" : prefix;
  for (const char* ending : {".json", ".svg"}) keep_apart(start + ending, scene);
  Output json(start + ".json"), picture(start + ".svg");
  if (options.untrusted) {
    RunOptions writes = options;
    writes.threads = 1;
    writes.outputs = {start + ".json", start + ".svg"};
    confine(reach_of(writes, scene, home));
  }
  Study studied;
  {
    const StatusLine line;
    studied = study(options, home, report_budget, [&](const std::string& what, double part) { line.show(what, part); });
  }
  if (Interrupt::asked()) say("stopped; this is what the runs until then tell");
  const double ns = product_time();
  json.write(report_json(studied, ns));
  picture.write(report_picture(studied));
  json.keep();
  picture.keep();
  std::cout << printable(report_text(studied, ns)) << std::flush;
  for (const std::string& warning : studied.warnings) say(warning);
  return 0;
}

}  // namespace pantin::player
