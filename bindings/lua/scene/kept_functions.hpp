#pragma once
// What of a state is the script's: functions that rows of the world hold, and laws that call them.
#include <memory>

#include "lua/scene/heap.hpp"

namespace pantin::lua {

/// Writes the functions of a script, or makes them anew. Throws Error for one that is not the script's.
class KeptFunctions final : public Outsider {
 public:
  KeptFunctions(Script& script, HeapWriter* to, HeapReader* from) : script_(script), to_(to), from_(from) {}

  void keep(Writer& to, const std::function<void()>& function) override;
  void keep(Writer& to, const std::function<void(double)>& function) override;
  void keep(Writer& to, const std::function<double()>& function) override;
  void keep(Writer& to, const std::function<bool()>& function) override;
  void keep(Writer& to, const std::function<double(double)>& function) override;
  void keep(Writer& to, const std::function<Vec3(double)>& function) override;
  void keep(Writer& to, const std::function<Quat(double)>& function) override;
  void keep(Writer& to, const std::function<void(ParticleId)>& function) override;
  void keep(Writer& to, const std::function<void(ConnectionId)>& function) override;
  void keep(Writer& to, const std::function<std::optional<Wait>()>& function) override;
  void make(Reader& from, std::function<void()>& function) override;
  void make(Reader& from, std::function<void(double)>& function) override;
  void make(Reader& from, std::function<double()>& function) override;
  void make(Reader& from, std::function<bool()>& function) override;
  void make(Reader& from, std::function<double(double)>& function) override;
  void make(Reader& from, std::function<Vec3(double)>& function) override;
  void make(Reader& from, std::function<Quat(double)>& function) override;
  void make(Reader& from, std::function<void(ParticleId)>& function) override;
  void make(Reader& from, std::function<void(ConnectionId)>& function) override;
  void make(Reader& from, std::function<std::optional<Wait>()>& function) override;
  void keep_called(Writer& to, const std::shared_ptr<Called>& called) override;
  std::shared_ptr<Called> make_called(Reader& from) override;

 private:
  Script& script_;
  HeapWriter* to_;
  HeapReader* from_;
};

void visit_law(HeapWriter& heap, Writer& to, ResolvedLaw& law);
/// `captured` is 1 where it is still to be found, once all values are there, else 0.
void visit_law(HeapReader& heap, Reader& from, ResolvedLaw& law);
/// Finds what a law that was read sees of the script's values.
void find_captured(ResolvedLaw& law);

}  // namespace pantin::lua
