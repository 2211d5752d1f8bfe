// A method defined by the user, loaded by the command:  scree run rigid.toml --load build/librigid_method.so
#include "coupling/bodies/methods.h"
#include "coupling/library.h"
#include "rigid_pool.h"

namespace {

void add() {
  scree::coupling::Method rigid;
  rigid.name = "rigid";
  rigid.meaning = "Rigid blocks.";
  rigid.keys = {{"inertia_factor", "", 0.0, true, 1e6, false,
                 "Factor of the moment of inertia: above 1, rocking and rolling are slower.", "1.0"}};
  rigid.make = [](scree::coupling::Method::Constants c) { return std::make_unique<scree::rigid::RigidPool>(c[0]); };
  scree::coupling::register_method(rigid);
}

}  // namespace

SCREE_LIBRARY(add);
