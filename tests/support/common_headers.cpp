// Owns the precompiled headers of the test programs, see tests/CMakeLists.txt. Nobody runs it.
int main() { return 0; }
