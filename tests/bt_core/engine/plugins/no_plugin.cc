// A library of something else.
extern "C" int Answer() { return 42; }
