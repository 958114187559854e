# Sourced by the scripts that use the artefacts of a release as a stranger does.
# FOOTBALL_RELEASE is a folder that .ci/release has filled; without it, `artefacts` makes what the script needs. .ci/run names one folder for all scripts, so each artefact is made once.

# artefacts KIND FILE TREE: sets `release` and `version`. Runs .ci/release in TREE for these kinds, unless the folder has FILE, a pattern. Code compiled ahead of time is for this
# machine alone, unless FOOTBALL_FULL is 1, as in .ci/run --full.
artefacts() {
  release=${FOOTBALL_RELEASE:-$work/release}
  if ! compgen -G "$release/$2" > /dev/null; then
    version=$(cd "$3" && env -u NUGET_PACKAGES dotnet msbuild src/Football.Physics -restore -t:FindVersion -getProperty:Version)
    local here=(--here)
    [[ ${FOOTBALL_FULL:-} != 1 ]] || here=()
    # .ci/run has built its tree with the analyzers. Without them, each project would be compiled again, and once more by the tests.
    local analyzers=(RunAnalyzers=false)
    [[ ${CI:-} != true || $3 != "$PWD" ]] || analyzers=(RunAnalyzers=)
    env -u NUGET_PACKAGES "${analyzers[@]}" "$3/.ci/release" "$version" "$release" --work-tree "${here[@]}" --only "$1"
  fi
  release=$(cd "$release" && pwd)
  version=$(cd "$release" && ls | sed -nE "s/^(Football\.Physics\.Tool|Football\.Physics|football-physics-c|football-physics)[.-]([0-9]+\.[0-9]+\.[0-9]+[0-9A-Za-z.-]*)(\.nupkg|\.tgz|-linux-[a-z0-9]+\.tar\.gz)$/\2/p" | head -n 1)
}
