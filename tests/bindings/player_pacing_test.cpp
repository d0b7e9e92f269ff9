#include <catch2/catch.hpp>

#include "player/pacing.hpp"

using pantin::player::Pacing;

namespace {

/// Plays `frames` frames of `elapsed` [s] with steps that cost `cost` [s] each, as the window does; returns the steps.
int play_frames(Pacing& pacing, int frames, double elapsed, double step, double pace, double cost) {
  int steps = 0;
  for (int i = 0; i < frames; i++) {
    int due = pacing.begin_frame(elapsed, step, pace);
    int done = 0;
    while (done < due && (done == 0 || pacing.has_time(done * cost))) done++;
    pacing.end_frame(done, done * cost);
    steps += done;
  }
  return steps;
}

}  // namespace

TEST_CASE("pacing: wall time becomes whole steps and loses none") {
  Pacing pacing;
  CHECK(play_frames(pacing, 600, 1.0 / 60.0, 1.0 / 240.0, 1.0, 1e-5) == 2400);
  CHECK_FALSE(pacing.slow_motion());
  CHECK(pacing.speed() == Approx(1.0).epsilon(0.02));
}

TEST_CASE("pacing: frames that are no multiple of a step") {
  Pacing pacing;
  int steps = play_frames(pacing, 1000, 0.0171, 1.0 / 240.0, 1.0, 1e-5);
  CHECK(steps == Approx(17.1 * 240).margin(1.0));
}

TEST_CASE("pacing: the scene's pace counts") {
  Pacing half, treble;
  CHECK(play_frames(half, 600, 1.0 / 60.0, 1.0 / 240.0, 0.5, 1e-5) == 1200);
  CHECK(play_frames(treble, 600, 1.0 / 60.0, 1.0 / 240.0, 3.0, 1e-5) == 7200);
}

TEST_CASE("pacing: a scene that is too slow runs in slow motion and says so") {
  Pacing pacing;
  // 240 steps a second at 10 ms each want 2.4 s of work a second.
  double frame = 1.0 / 60.0, cost = 0.010, clock = 0.0;
  int steps = 0;
  for (int i = 0; i < 400; i++) {
    int done = play_frames(pacing, 1, frame, 1.0 / 240.0, 1.0, cost);
    frame = 0.005 + done * cost;  // drawing, and the steps
    CHECK(frame <= 0.005 + Pacing::least_budget + cost);
    clock += frame;
    steps += done;
  }
  CHECK(steps > 400);
  CHECK(pacing.slow_motion());
  CHECK(pacing.speed() == Approx(steps / 240.0 / clock).epsilon(0.1));
}

TEST_CASE("pacing: where drawing is slow, steps may take as long as it does") {
  Pacing pacing;
  double frame = 0.1, steps = 0.0, clock = 0.0;
  for (int i = 0; i < 100; i++) {
    int done = play_frames(pacing, 1, frame, 1.0 / 240.0, 1.0, 0.01);
    frame = 0.08 + done * 0.01;
    clock += frame;
    steps += done;
  }
  CHECK(steps * 0.01 == Approx(0.5 * clock).epsilon(0.15));
}

TEST_CASE("pacing: one step that takes longer than a frame is still taken") {
  Pacing pacing;
  CHECK(play_frames(pacing, 20, 0.5, 1.0 / 240.0, 1.0, 0.5) == 20);
  CHECK(pacing.slow_motion());
}

TEST_CASE("pacing: a stall is not made up for") {
  Pacing pacing;
  play_frames(pacing, 60, 1.0 / 60.0, 1.0 / 240.0, 1.0, 1e-5);
  int after_stall = play_frames(pacing, 1, 30.0, 1.0 / 240.0, 1.0, 1e-5);
  CHECK(after_stall <= 60);
  CHECK(play_frames(pacing, 60, 1.0 / 60.0, 1.0 / 240.0, 1.0, 1e-5) == Approx(240).margin(1));
}

TEST_CASE("pacing: a slow scene that becomes quick is back at full speed within seconds") {
  Pacing pacing;
  play_frames(pacing, 100, 0.1, 1.0 / 240.0, 1.0, 0.02);
  REQUIRE(pacing.slow_motion());
  play_frames(pacing, 300, 1.0 / 60.0, 1.0 / 240.0, 1.0, 1e-5);
  CHECK_FALSE(pacing.slow_motion());
}

TEST_CASE("pacing: steps longer than a frame come when they are due") {
  Pacing pacing;
  CHECK(play_frames(pacing, 120, 1.0 / 60.0, 0.25, 1.0, 1e-5) == 8);
}
