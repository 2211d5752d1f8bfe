#include "coupling/sink.h"

namespace scree::coupling {

std::string_view name(EventKind kind) {
  switch (kind) {
    case EventKind::stage_start:
      return "stage_start";
    case EventKind::stage_step:
      return "stage_step";
    case EventKind::stage_rule:
      return "stage_rule";
    case EventKind::stage_end:
      return "stage_end";
    case EventKind::transfer:
      return "transfer";
    case EventKind::step_cut:
      return "step_cut";
    case EventKind::partition:
      return "partition";
    case EventKind::sleep:
      return "sleep";
    case EventKind::bolt_broken:
      return "bolt_broken";
    case EventKind::excavated:
      return "excavated";
    case EventKind::filled:
      return "filled";
    case EventKind::not_converged:
      return "not_converged";
    case EventKind::warning:
      return "warning";
  }
  return "unknown";
}

bool comes_often(std::string_view kind) {
  return kind == name(EventKind::step_cut) || kind == name(EventKind::transfer) || kind == name(EventKind::partition) ||
         kind == name(EventKind::sleep);
}

std::string_view name(Integrator integrator) {
  switch (integrator) {
    case Integrator::explicit_:
      return "explicit";
    case Integrator::implicit:
      return "implicit";
    case Integrator::partitioned:
      return "partitioned";
  }
  return "unknown";
}

}  // namespace scree::coupling
