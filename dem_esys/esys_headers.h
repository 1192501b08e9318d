// ESyS-Particle's headers, with what they forget and what they keep to themselves: a worker's
// particles are reached through protected members.
#pragma once

#include <mpi.h>

#include <boost/shared_ptr.hpp>
#include <cstring>
#include <fstream>
#include <iostream>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// MPI-1 names that are gone.
#define MPI_Address MPI_Get_address
#define MPI_Type_struct MPI_Type_create_struct
#define private public
#define protected public
#include "Model/BodyForceGroup.h"
#include "Model/RotParticle.h"
#include "Parallel/RotSubLattice.h"
#include "Parallel/SubLattice.h"
#include "Parallel/SubLatticeControler.h"
#undef private
#undef protected
