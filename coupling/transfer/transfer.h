// Change of method of bodies between stages: affine motion exactly, the rest to the reservoir.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "coupling/bodies/setup.h"
#include "coupling/sink.h"

namespace scree::coupling {

/// Method and mesh of a block in a stage.
struct BodyRequest {
  std::string method;
  Formulation form{};
  bool absent = false;  // the block is absent in the stage
};
/// Requests of all blocks, in their order.
/// @param explicit_side  State::explicit_side; empty: as a stage begins
/// @param other_method   RuleMemory::other_method; empty: as a stage begins
[[nodiscard]] std::vector<BodyRequest> body_requests(const Model& model, const Stage& stage,
                                                     std::span<const char> explicit_side = {},
                                                     std::span<const char> other_method = {});

/// Records of all blocks at rest in their model shape.
[[nodiscard]] std::vector<BodyRecord> initial_records(const Model& model, const std::vector<BodyRequest>& request);

/// Result of a transfer: the new bodies, one row per body that changed, blocks that became absent and present.
struct TransferReport {
  std::unique_ptr<Setup> setup;
  std::vector<TransferRow> rows;
  std::vector<BlockId> left, came;
};

/// Hands a synchronised state over to new bodies. Bodies whose method and mesh stay keep every bit of q and v, also
/// where mass or kinematics change: their energies are measured anew and the difference is booked. The others pass
/// through release() and place(), with the stage's mode of transfer; a body that returns to the method and mesh that it
/// left last takes its fields out of the reservoir. Contact memory is transferred by corner and edge; the stretch of a
/// spring is kept on its new edge; anchors of point supports are shifted so that their forces stay. Energies, reservoir
/// and cross terms are booked; one row per body that changed.
/// Blocks that are absent from this stage on are removed with their energies, contacts and supports (construction.h);
/// blocks that were absent before are added at rest, in their model shape, without stress.
/// @param clocks  of the new setup
/// @source docs/theory/transfer.md, "Affine part"
[[nodiscard]] TransferReport transfer_bodies(const Model& model, const Methods& methods, const Setup& from,
                                             const Stage& stage, State& state, Clocks clocks = {});

}  // namespace scree::coupling
