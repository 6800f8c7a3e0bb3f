# nix-build tools/packaging/nix        the command and, in result/lib, the Python module
#
# Run here: nix-instantiate --parse (Nix 2.8).  Not run: the build, which needs a copy of Nixpkgs that the machines this
# was written on cannot reach.  Nixpkgs 23.11 is the last release with FLINT 2.9, Arb, Antic and Calcium apart.
{ pkgs ? import (fetchTarball "https://github.com/NixOS/nixpkgs/archive/nixos-23.11.tar.gz") { } }:

let
  root = ../../..;
  project = builtins.readFile (root + "/CMakeLists.txt");
  python = pkgs.python311;
in
pkgs.stdenv.mkDerivation {
  pname = "kovacic";
  version = builtins.head (builtins.match ".*project\\(kovacic VERSION ([0-9.]+).*" project);
  src = builtins.path {
    path = root;
    name = "kovacic-source";
    filter = path: type: !(type == "directory" && builtins.elem (baseNameOf path) [ "build" ".git" ]);
  };

  nativeBuildInputs = with pkgs; [ cmake ninja pkg-config ];
  buildInputs = with pkgs; [
    gmp mpfr flint arb antic calcium cln ginac tomlplusplus z3 nlohmann_json nettle cli11 fmt
    python python.pkgs.pybind11
  ];
  cmakeFlags = [ "-DCMAKE_BUILD_TYPE=Release" "-DBUILD_TESTING=OFF" "-DKOV_PYTHON=${python}/bin/python3" ];
  ninjaFlags = [ "kovacic" "python" ];
  installPhase = ''
    cmake --install . --component command
    cmake --install . --component python
  '';

  meta = {
    description = "Differential Galois groups and non-integrability proofs, exactly";
    license = pkgs.lib.licenses.gpl3Plus;
    platforms = pkgs.lib.platforms.linux;
    mainProgram = "kovacic";
  };
}
