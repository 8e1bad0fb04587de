#include "TetrahedralSplit.h"
