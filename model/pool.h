// All bodies of one method, by five roles. A method derives from Pool and implements the roles that it supports;
// functions that a role does not require have a default.
#pragma once

#include "model/body_output.h"
#include "model/body_set.h"
#include "model/body_transfer.h"
#include "model/explicit_operator.h"
#include "model/implicit_operator.h"

namespace scree {

/// The bodies that use one method. The driver, the integrators and output each use only the role that they need.
class Pool : public BodySet,
             public ExplicitOperator,
             public ImplicitOperator,
             public BodyTransfer,
             public BodyOutput {};

}  // namespace scree
