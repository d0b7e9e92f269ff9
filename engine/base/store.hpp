#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "base/handle.hpp"
#include "base/interruptible.hpp"

namespace pantin {

/// Why a handle is dead: what it named, when it went and who removed it.
struct Obituary {
  std::string what;              ///< "body 'arm'"
  double time = 0.0;             ///< [s]
  std::string who;               ///< "scene.lua:12", "hand 1", "its lifetime", …
  std::uint32_t generation = 0;  ///< of the handle that died
  std::string name = {};         ///< its own, where rows have one
  friend bool operator==(const Obituary&, const Obituary&) = default;
};

/// The last generation that was given out of each slot. Assigning never takes one back: what was made after the state
/// that is put back stays dead for ever.
class Generations {
 public:
  Generations() = default;
  Generations(const Generations&) = default;
  Generations(Generations&&) = default;
  Generations& operator=(const Generations& other) {
    if (last_.size() < other.last_.size()) last_.resize(other.last_.size());
    for (std::size_t slot = 0; slot < other.last_.size(); slot++)
      last_[slot] = std::max(last_[slot], other.last_[slot]);
    return *this;
  }
  ~Generations() = default;

  std::uint32_t next(std::uint32_t slot) {
    if (last_.size() <= slot) last_.resize(slot + 1);
    return ++last_[slot];
  }
  /// Whether a handle was given out, in a state that may have been taken back.
  bool known(std::uint32_t slot, std::uint32_t generation) const {
    return slot < last_.size() && generation <= last_[slot];
  }

 private:
  friend struct StateFields;         ///< of snapshot/state_fields.hpp
  std::vector<std::uint32_t> last_;  ///< (slots)
};

/// Rows of one kind. A row stays in its slot for life, so slots may be used as indices between two edits; the slots of
/// the dead are given out again under a new generation. A copy may be assigned back: the rows are then as they were, and
/// handles of what was made since are dead.
template <class Row>
class Store {
 public:
  using Id = Handle<Row>;

  /// Throws GivenUp.
  Id add(Row row) {
    stop_if_given_up();
    std::uint32_t slot;
    if (free_.empty()) {
      slot = static_cast<std::uint32_t>(rows_.size());
      rows_.push_back(std::move(row));
      slots_.push_back({});
    } else {
      slot = free_.back();
      free_.pop_back();
      rows_[slot] = std::move(row);
    }
    slots_[slot].alive = true;
    slots_[slot].generation = generations_.next(slot);
    size_++;
    return {slot + 1, slots_[slot].generation};
  }

  void remove(Id id, Obituary obituary) {
    (void)(*this)[id];
    obituary.generation = id.generation;
    if constexpr (requires(Row row) { row.name; }) obituary.name = rows_[id.slot - 1].name;
    if (obituaries_.size() < id.slot) obituaries_.resize(id.slot);
    obituaries_[id.slot - 1] = std::move(obituary);
    slots_[id.slot - 1].alive = false;
    rows_[id.slot - 1] = Row{};
    free_.push_back(id.slot - 1);
    size_--;
  }

  bool alive(Id id) const {
    return id.slot != 0 && id.slot <= slots_.size() && slots_[id.slot - 1].alive &&
           slots_[id.slot - 1].generation == id.generation;
  }

  /// The row of a live handle; throws Error with the handle's story otherwise.
  Row& operator[](Id id) {
    if (!alive(id)) [[unlikely]]
      throw Error(story(id));
    return rows_[id.slot - 1];
  }
  const Row& operator[](Id id) const {
    if (!alive(id)) [[unlikely]]
      throw Error(story(id));
    return rows_[id.slot - 1];
  }

  /// "body 'arm' was removed at 1.5 s by scene.lua:12"
  std::string story(Id id) const {
    if (!id) return "this names nothing";
    if (!generations_.known(id.slot - 1, id.generation)) return "this handle was never given out by this world";
    if (id.slot > slots_.size() || id.generation > slots_[id.slot - 1].generation)
      return "this was made after the moment that was restored, and is gone with what came after it";
    const Obituary* o = obituary(id);
    if (!o) return "this was removed long ago, and its slot has been used again since";
    return text(o->what, " was removed at ", o->time, " s by ", o->who);
  }

  /// The name of what lives or died; throws Error with its story where that is forgotten.
  const std::string& name(Id id) const {
    const Obituary* o = alive(id) ? nullptr : obituary(id);
    return o ? o->name : (*this)[id].name;
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  /// Number of slots, dead ones included; `alive_at` tells which live.
  std::uint32_t slots() const { return static_cast<std::uint32_t>(rows_.size()); }
  bool alive_at(std::uint32_t slot) const { return slots_[slot].alive; }
  Row& at_slot(std::uint32_t slot) { return rows_[slot]; }
  const Row& at_slot(std::uint32_t slot) const { return rows_[slot]; }
  Id id_at(std::uint32_t slot) const { return {slot + 1, slots_[slot].generation}; }

  /// Live handles in the order of their rows' `serial`, that is, of making.
  std::vector<Id> ids() const;

 private:
  friend struct StateFields;  ///< of snapshot/state_fields.hpp
  /// Null where there is none, or the slot was used again since.
  const Obituary* obituary(Id id) const {
    if (id.slot == 0 || id.slot > obituaries_.size()) return nullptr;
    const Obituary& o = obituaries_[id.slot - 1];
    return o.generation == id.generation ? &o : nullptr;
  }
  struct Slot {
    bool alive = false;
    std::uint32_t generation = 0;
  };
  std::vector<Row> rows_;
  std::vector<Slot> slots_;
  std::vector<Obituary> obituaries_;  ///< (slots, up to the last that a row was removed from)
  std::vector<std::uint32_t> free_;
  Generations generations_;
  std::size_t size_ = 0;
};

template <class Row>
std::vector<Handle<Row>> Store<Row>::ids() const {
  std::vector<Id> list;
  list.reserve(size_);
  bool sorted = true;
  for (std::uint32_t s = 0; s < slots(); s++)
    if (slots_[s].alive) {
      sorted = sorted && (list.empty() || rows_[list.back().slot - 1].serial < rows_[s].serial);
      list.push_back(id_at(s));
    }
  if (!sorted)
    std::sort(list.begin(), list.end(),
              [&](Id a, Id b) { return rows_[a.slot - 1].serial < rows_[b.slot - 1].serial; });
  return list;
}

}  // namespace pantin
