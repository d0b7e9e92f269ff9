#include "player/program.hpp"

int main(int argc, char** argv) { return pantin::player::run_program(argc, argv); }
