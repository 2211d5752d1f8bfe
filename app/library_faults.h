// Faults inside HDF5, which goes on where an allocation for its own tables has failed, and falls over what is missing.
#pragma once

namespace scree::app {

/// A signal by which the program itself ends (a fault, an abort) and whose innermost call of HDF5 or Scree is one of
/// HDF5 ends it from then on with kFiles and a message; what was stored before the last checkpoint is safe. All other
/// such signals end it as they did. Does nothing where others, such as sanitizers, look at these signals already.
void take_faults_of_hdf5();

}  // namespace scree::app
