#pragma once
// Force elements at work: their laws, ready to be run on the sites of the particles that they act on.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "laws/run/bonds.hpp"
#include "laws/run/fields.hpp"
#include "laws/run/pairs.hpp"
#include "model/force_element.hpp"

namespace pantin {

struct World;
struct Forces;

/// One law at work: of an interaction, of a field, or of all connections that have it.
struct ActingElement {
  std::shared_ptr<const Law> law;
  bool solved = false;    ///< articulates apply the forces; here connections only tell their energy
  double energy = 0.0;    ///< [J] when it was last told
  double at_first = 0.0;  ///< [J] when it began to act

  explicit ActingElement(std::shared_ptr<const Law> by) : law(std::move(by)) {}
  virtual ~ActingElement() = default;
  ActingElement(const ActingElement&) = default;
  ActingElement(ActingElement&&) = default;
  ActingElement& operator=(ActingElement&&) = default;

  virtual LawOnSites& on() = 0;
  /// Where the law was put to use, of connections the first time; null where all are gone.
  virtual const ForceElement* row(const World& world) const = 0;
  /// As the ledger has it: connections go by their law.
  virtual std::string name(const World& world) const;
  /// Values of the law's parameters; none where each connection has its own.
  virtual std::vector<double> parameters(const World& world) const;
  /// Those of some sites, in rising order, that are what the law calls its particle `who`.
  virtual std::vector<std::uint32_t> sites_of(const World& world, const Forces& forces, std::size_t who,
                                              std::span<const std::uint32_t> some) const = 0;
};

struct ActingInteraction final : ActingElement {
  InteractionId id;
  Pairs pairs;
  Exclusions bonded;  ///< pairs within so many connections as the law leaves out

  ActingInteraction(InteractionId of, std::shared_ptr<const Law> by, const Forces& forces, const Workers& workers);
  LawOnSites& on() override { return pairs; }
  const ForceElement* row(const World& world) const override;
  std::vector<std::uint32_t> sites_of(const World& world, const Forces& forces, std::size_t who,
                                      std::span<const std::uint32_t> some) const override;
};

struct ActingField final : ActingElement {
  FieldId id;
  Fields fields;

  ActingField(FieldId of, std::shared_ptr<const Law> by, const Forces& forces, const Workers& workers);
  LawOnSites& on() override { return fields; }
  const ForceElement* row(const World& world) const override;
  std::vector<std::uint32_t> sites_of(const World& world, const Forces& forces, std::size_t who,
                                      std::span<const std::uint32_t> some) const override;
};

struct ActingConnections final : ActingElement {
  std::vector<ConnectionId> ids;       ///< in the order of making
  std::vector<std::uint64_t> serials;  ///< of them
  BondList bond_list;
  Bonds bonds;

  ActingConnections(std::shared_ptr<const Law> by, bool are_solved, const Forces& forces, const Workers& workers);
  LawOnSites& on() override { return bonds; }
  const ForceElement* row(const World& world) const override;
  std::string name(const World& world) const override;
  std::vector<double> parameters(const World& world) const override;
  std::vector<std::uint32_t> sites_of(const World& world, const Forces& forces, std::size_t who,
                                      std::span<const std::uint32_t> some) const override;
};

}  // namespace pantin
