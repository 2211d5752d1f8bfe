// Faults inside HDF5, which continues after a failed allocation for its own tables and then fails on missing data.
#pragma once

namespace scree::app {

/// From this call on, a fault or an abort whose innermost call among those of HDF5 and Scree is one of HDF5 ends the
/// program with kFiles and a message; data stored before the last checkpoint are safe. All other faults and aborts end
/// it as before. A signal that already has a handler, such as that of a sanitizer, is left alone.
void take_faults_of_hdf5();

}  // namespace scree::app
