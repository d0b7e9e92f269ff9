// Shipped scenes, played at random and played again.
#include "bindings/recorded_person.hpp"

using namespace pantin;

namespace {

void play_and_check(const std::string& name, double seconds, std::uint64_t seed) {
  CAPTURE(name, seed);
  const support::Folder folder;
  std::uint64_t hash = 0;
  {
    RecordedPerson person(sources::folder() + "/scripts/scenes/" + name + ".lua", folder / "play.rec", seed);
    person.play(seconds);
    hash = person.hash();
    person.finish();
  }
  player::RunOptions options;
  options.threads = 2;
  options.headless = true;
  player::Replay replay(player::read_recording(folder / "play.rec"), options, "elsewhere");
  while (replay.step()) {}
  CHECK(replay.mismatch() == "");
  CHECK(replay.remarks().empty());
  CHECK(state_hash(replay.scene().world()) == hash);
}

}  // namespace

TEST_CASE("recording: shipped scenes in which somebody does anything are played again to the bit") {
  for (const char* name : {"chain", "bridge", "cloth", "membrane", "buckyball", "rings"}) play_and_check(name, 2.0, 11);
}

TEST_CASE("recording: minutes of anything in shipped scenes are played again to the bit", "[slow]") {
  for (const char* name : {"chain", "bridge"}) play_and_check(name, 120.0, 3);
  for (const char* name : {"cloth", "membrane"}) play_and_check(name, 10.0, 4);
  play_and_check("cloth", 20.0, 5);  // points that slept without a law on them wake as springs become solved
}
