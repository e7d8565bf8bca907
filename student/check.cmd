@echo off
rem Builds the program that checks (given\check\), where it isn't there yet, and starts it.
setlocal
cd /d "%~dp0"
if not "%cd:;=%"=="%cd%" (echo check: CMake cannot build in a folder whose path has ; in it: rename the folder>&2 & exit /b 3)
where cmake >nul 2>nul || (echo check: CMake is missing here; use the Developer PowerShell of Visual Studio, or: winget install cmake>&2 & exit /b 3)
set toolchain=
if defined VCPKG_ROOT set toolchain="-DCMAKE_TOOLCHAIN_FILE=%VCPKG_ROOT%/scripts/buildsystems/vcpkg.cmake"
rem The folder may have been moved: what CMake built in the old place is of no use.
if exist build\CMakeCache.txt (findstr /x /l /i /c:"CMAKE_HOME_DIRECTORY:INTERNAL=%cd:\=/%" build\CMakeCache.txt >nul || rmdir /s /q build)
if not exist build mkdir build
if not exist build\check_program.exe (
  echo check: building for the first time; this takes about a minute>&2
  cmake -S . -B build %toolchain% >build\prepare.txt 2>&1 && cmake --build build --config Debug --parallel --target prepared >>build\prepare.txt 2>&1 || (type build\prepare.txt >&2 & exit /b 3)
)
build\check_program.exe %*
