// State and forces of a contact point while its step is solved.
#pragma once

#include "coupling/contact_memory.h"

namespace scree::coupling {

/// A contact point during the open-close iteration.
struct ContactTrial {
  ContactStatus status = ContactStatus::open;
  double direction = 0.0;  // sign of the friction force while slipping
  bool opens = false;      // dilates while it slips: has not reached the end of dilation
  double opened = 0.0;     // opening by dilation in the step; `gap` does not include it [m]
  double fn = 0.0, ft = 0.0, gap = 0.0, stretch = 0.0, moved = 0.0;  // linear results; moved: tangential change
  // Normal spring and dashpot of a step h as one spring: k = k_n + c_n/h, k at = k_n g_n, so that
  //   -k_n g - c_n (g - g_n)/h = -k (at + g - g_n).
  double k = 0.0, at = 0.0;  // [N/m], [m]
  // Closed, but the dashpot would pull by more than the point bears: its force is the largest pull that it bears.
  bool slack = false;
};

}  // namespace scree::coupling
