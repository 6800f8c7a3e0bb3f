#include "linode/singularities.hpp"
