#ifndef ThreadHandOver_h
#define ThreadHandOver_h

/// How long a word takes from one thread to another. Two cores that share a cache need some 25 ns,
/// others 150 and more: what threads exchange then costs more, and timings are others.
namespace ThreadHandOver
{
/// The best of several rounds, in nanoseconds; 0 where there is one core alone.
double Measure();

void Print();
}

#endif
