// What a run does with a model: its stages, output and streaming.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/ids.h"

namespace scree::coupling {

enum class Integrator { explicit_, implicit };

/// Settings of the open-close iteration and of step control (thesis 3.2.2, 4.5).
struct StepControl {
  int max_passes = 12;            // open-close passes before the step is cut; the thesis uses 6
  double max_displacement = 0.0;  // largest displacement a step [m]; 0: a hundredth of the smallest block's width
  double cut_factor = 1.0 / 3.0;  // a step that fails is repeated with this fraction
  int max_cuts = 12;              // consecutive cuts before the run gives up
};

struct MethodRule {
  std::vector<BlockId> blocks;
  std::string method;
};

struct Stage {
  std::string name;
  std::string method;  // for blocks that no rule names
  std::vector<MethodRule> rules;
  Integrator integrator = Integrator::explicit_;
  std::optional<double> dt;  // [s]; empty: auto, explicit only
  double safety = 0.8;       // fraction of the certified explicit bound that auto takes
  Tick duration = 0;
  double cover_size = 0.0;  // NMM mesh [m]
  double damping = 0.0;     // mass-proportional, on velocities less their affine part; explicit [1/s]
  bool rest = false;        // motion is taken out: explicit at peaks of kinetic energy, implicit after every step
  StepControl control;
};

struct OutputPlan {
  Tick every = 0;          // a frame every so many ticks
  Tick history_every = 0;  // monitors and ledger
};

struct LivePlan {
  bool enabled = false;
  std::string url = "udpm://239.255.76.67:7667?ttl=0";
  double rate = 30.0;  // frames a second of wall time, at most
};

struct Plan {
  std::vector<Stage> stages;
  double detection = 0.0;  // contact detection distance [m]; 0: auto
  OutputPlan output;
  LivePlan live;
  int threads = 0;  // 0: as many as the machine has
};

}  // namespace scree::coupling
