// Two players in two processes who predict each other's inputs, go back where they were wrong, and never differ:
//
//   pantin_rollback PLAYER OWN_PORT OTHER_PORT [FRAMES [DELAY [LOSS]]]
//
// PLAYER is 0 or 1, DELAY in s, LOSS 0 … 1. Each frame a player plays its own input at once, with the last one known of
// the other. When inputs come that were predicted wrong, the world goes back to the snapshot before the first of them, and
// the frames since are played again. What both have played with all inputs known is the same to the bit: they tell each
// other its hash.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "game.hpp"
#include "link.hpp"
#include "measure/measure.hpp"
#include "snapshot/snapshot.hpp"

namespace rollback {
namespace {

constexpr std::uint32_t most_ahead = 30;  // frames that are played on predicted inputs; a ring keeps so many snapshots
constexpr std::uint32_t most_sent = 64;   // inputs in a packet: all that the other may lack

/// Plain, for a machine of the same kind.
struct Packet {
  std::uint32_t first = 0, count = 0;  ///< frames whose inputs it has
  std::uint32_t known = 0;             ///< inputs of the other that came, from the first frame on
  std::uint32_t checked = 0;           ///< frames that were played with all inputs known,
  std::uint64_t hash = 0;              ///< and the world's hash after them
  std::uint8_t done = 0;               ///< all frames are, and the other's too
  Input inputs[most_sent] = {};
};

class Player {
 public:
  Player(int number, std::uint32_t frames, Link& link)
      : own_(static_cast<std::size_t>(number)), frames_(frames), link_(link), hashes_(frames + 1), played_(frames) {
    hashes_[0] = pantin::state_hash(game_.world());
  }

  /// Plays to the end. Throws std::runtime_error where the two differ, or the other is gone.
  void play();
  void print() const {
    std::printf("player %zu: %u frames, hash %016llx, went back %u times, played %u frames again\n", own_, frames_,
                static_cast<unsigned long long>(hashes_[frames_]), went_back_, again_);
  }

 private:
  void listen();
  void take(const Packet& packet);
  void go_back();
  void frame();
  void tell();
  void compare(std::uint32_t frames, std::uint64_t hash) const;

  std::uint32_t known() const { return static_cast<std::uint32_t>(inputs_[1 - own_].size()); }
  /// What is not known is what was known last.
  Input input(std::size_t player, std::uint32_t frame) const {
    const std::vector<Input>& list = inputs_[player];
    if (frame < list.size()) return list[frame];
    return list.empty() ? Input{0} : list.back();
  }

  std::size_t own_;
  std::uint32_t frames_;
  Link& link_;
  Game game_;
  std::uint32_t now_ = 0;                                ///< frames played
  std::uint32_t checked_ = 0;                            ///< of these with all inputs known
  std::array<std::vector<Input>, 2> inputs_;             ///< (players) (frames) known
  std::array<pantin::Snapshot, most_ahead + 1> states_;  ///< ring: before each frame
  std::vector<std::uint64_t> hashes_;                    ///< after so many frames; final up to `checked_`
  std::vector<Inputs> played_;                           ///< (frames)
  std::uint32_t other_knows_ = 0;
  std::pair<std::uint32_t, std::uint64_t> other_checked_;  ///< frames and hash, to be compared
  bool other_done_ = false;
  std::uint32_t went_back_ = 0, again_ = 0;
};

void Player::play() {
  using Clock = std::chrono::steady_clock;
  Clock::time_point heard = Clock::now(), done;
  // At the end the other is told for a while: it may have lost all that was said before.
  for (bool all = false; !all || (!other_done_ && Clock::now() - done < std::chrono::seconds(2));) {
    const std::uint32_t before = known();
    listen();
    if (known() != before) heard = Clock::now();
    if (Clock::now() - heard > std::chrono::seconds(20)) throw std::runtime_error("the other player is gone");
    if (now_ < frames_ && now_ - checked_ < most_ahead) frame();
    tell();
    if (!all && checked_ == frames_ && other_checked_.first == frames_) {
      all = true;
      done = Clock::now();
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(4));
  }
}

void Player::listen() {
  for (const std::string& bytes : link_.receive()) {
    Packet packet;
    if (bytes.size() != sizeof packet) continue;
    std::memcpy(&packet, bytes.data(), sizeof packet);
    take(packet);
  }
  go_back();
  if (other_checked_.first <= checked_) compare(other_checked_.first, other_checked_.second);
}

void Player::take(const Packet& packet) {
  if (packet.known > inputs_[own_].size() || packet.checked > frames_) return;  // it is of another game
  for (std::uint32_t i = 0; i < packet.count && i < most_sent; i++)
    if (packet.first + i == known() && known() < frames_) inputs_[1 - own_].push_back(packet.inputs[i]);
  other_knows_ = std::max(other_knows_, packet.known);
  if (packet.checked >= other_checked_.first) other_checked_ = {packet.checked, packet.hash};
  other_done_ = other_done_ || packet.done != 0;
}

/// To before the first frame that was played with a wrong prediction, and on again; what is right up to then is checked.
void Player::go_back() {
  std::uint32_t first = checked_;
  while (first < now_ && first < known() && played_[first][1 - own_] == input(1 - own_, first)) first++;
  checked_ = first;
  if (first == now_ || first >= known()) return;
  const std::uint32_t until = now_;
  pantin::restore(game_.world(), states_[first % states_.size()]);
  went_back_++;
  again_ += until - first;
  for (now_ = first; now_ < until;) frame();
  checked_ = std::min(now_, known());
}

void Player::frame() {
  if (now_ == inputs_[own_].size()) inputs_[own_].push_back(whim(static_cast<int>(own_), now_));
  pantin::take_snapshot(game_.world(), states_[now_ % states_.size()]);
  played_[now_] = {input(0, now_), input(1, now_)};
  game_.play(played_[now_]);
  hashes_[++now_] = pantin::state_hash(game_.world());
}

void Player::tell() {
  Packet packet;
  packet.first = other_knows_;
  packet.count = std::min(static_cast<std::uint32_t>(inputs_[own_].size()) - other_knows_, most_sent);
  for (std::uint32_t i = 0; i < packet.count; i++) packet.inputs[i] = inputs_[own_][packet.first + i];
  packet.known = known();
  packet.checked = checked_;
  packet.hash = hashes_[checked_];
  packet.done = checked_ == frames_ && other_checked_.first == frames_ ? 1 : 0;
  link_.send(std::string(reinterpret_cast<const char*>(&packet), sizeof packet));
}

void Player::compare(std::uint32_t frames, std::uint64_t hash) const {
  if (frames > 0 && hashes_[frames] != hash)
    throw std::runtime_error("the two worlds differ after frame " + std::to_string(frames));
}

}  // namespace
}  // namespace rollback

int main(int argc, char** argv) {
  if (argc < 4)
    return std::fprintf(stderr, "usage: %s PLAYER OWN_PORT OTHER_PORT [FRAMES [DELAY [LOSS]]]\n", argv[0]), 2;
  const auto number = [&](int i, double usual) { return i < argc ? std::strtod(argv[i], nullptr) : usual; };
  const auto port = [&](int i) {
    if (!(number(i, 0) >= 1 && number(i, 0) < 65536)) throw std::runtime_error("a port is 1 … 65535");
    return static_cast<std::uint16_t>(number(i, 0));
  };
  try {
    if (!(number(4, 600) >= 1 && number(4, 600) <= 1e6)) throw std::runtime_error("FRAMES is 1 … 1000000");
    rollback::Link link(port(2), port(3), {number(5, 0.05), number(6, 0.1)});
    rollback::Player player(number(1, 0) == 0.0 ? 0 : 1, static_cast<std::uint32_t>(number(4, 600)), link);
    player.play();
    player.print();
  } catch (const std::exception& error) { return std::fprintf(stderr, "pantin_rollback: %s\n", error.what()), 1; }
  return 0;
}
