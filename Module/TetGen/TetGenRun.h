/**
 * One run of TetGen that may fail.
 *
 * TetGen 1.5 frees its memory before it throws, and again while the exception leaves it: the
 * process dies of its first error. There its stages are called one by one, on an object that is
 * given back without its destructor after an error. Where CMake finds a TetGen that does not do so,
 * its own entry is called.
 */
#ifndef TetGenRun_h
#define TetGenRun_h

class tetgenbehavior;
class tetgenio;

namespace TetGenRun
{
/** 0, or TetGen's exit code. The switches p, Y, J, Q, c, q and a are followed. */
int Run(tetgenbehavior& behavior, tetgenio& in, tetgenio& out);
}

#endif
