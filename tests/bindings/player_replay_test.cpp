// Shipped scenes, played at random and played again.
#include "bindings/recorded_person.hpp"

using namespace pantin;

namespace {

struct Play {
  std::string scene;
  double seconds;
  std::map<std::string, std::string> set = {};
};

void play_and_check(const Play& play, std::uint64_t seed) {
  CAPTURE(play.scene, seed);
  const support::Folder folder;
  std::uint64_t hash = 0;
  {
    const std::string path = sources::folder() + "/scripts/scenes/" + play.scene + ".lua";
    RecordedPerson person(path, folder / "play.rec", seed, play.set);
    person.play(play.seconds);
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

const std::map<std::string, std::string> small_cloth = {{"threads", "10"}}, small_membrane = {{"amphiphiles", "60"}};

}  // namespace

TEST_CASE("recording: shipped scenes in which somebody does anything are played again to the bit") {
  for (const Play& play : {Play{"chain", 1}, Play{"bridge", 1}, Play{"cloth", 1, small_cloth},
                           Play{"membrane", 1, small_membrane}, Play{"buckyball", 1}, Play{"rings", 1}})
    play_and_check(play, 11);
}

TEST_CASE("recording: a minute of anything in shipped scenes are played again to the bit", "[slow][shipped]") {
  play_and_check({"chain", 60}, 3);
  play_and_check({"bridge", 10}, 3);
  for (const char* name : {"cloth", "membrane"}) play_and_check({name, 5}, 4);
}

TEST_CASE("recording: what is no line of one is told in plain words") {
  const support::Folder folder;
  const auto told = [&](const std::string& line) {
    support::write_file(folder / "text", line);
    return player::read_recording(folder / "text");
  };
  const std::string at = folder / "text" + std::string(":1: this is no recording that can be replayed: ");
  CHECK_THROWS_WITH(told("hello\n"), at + "the line is no JSON");
  CHECK_THROWS_WITH(told("{}\n"), at + "key 'pantin' not found");
  CHECK_THROWS_WITH(told(R"({"pantin":3,"version":1})"), at + "type must be string, but is number");
}
