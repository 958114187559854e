#!/usr/bin/env bash
# Mutates every line of a room of the library and plays the tests of behaviour that concern it: which mutants does none see?
#
#   tests/stryker.sh ROOM [FILE...]      ROOM: Contact, Air, Simulation or another folder of src/Football.Physics; FILE: files of it alone (ImpactLaw.cs)
#
# It takes six minutes to build and some seconds a mutant, which for a whole room is hours, and is no part of CI. The report is in artifacts/stryker/ROOM.
# FILTER chooses other tests (as dotnet test --filter does).
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
room=${1:?which room?}
shift
[ -d "$root/src/Football.Physics/$room" ] || { echo "there is no room $room" >&2; exit 2; }

# Quick tests, whose numbers are closed forms, reference cases or symmetries.
case $room in
    Contact) tests="Things.ImpactLawTests Things.SurfaceNumbersTests Things.BoundsTreeTests Things.EdgeTests Things.GoalTests Things.BodyTests Things.EngineColliderTests
        Things.SurfacePatternTests Motion.DefaultGroundTests Motion.WholeStepTests Motion.MeasuredImpactTests Motion.SlipDecayTests Reference.AmongReferenceTests Things.WorldReferenceTests" ;;
    Air) tests="Tests.Laws Motion.WindFieldTests Scenes.WindTests Motion.SpinDecayTests Motion.CustomForceTests Reference.MeasuredReferenceTests Reference.ReferenceTests" ;;
    Simulation) tests="Tests.Motion Things.EdgeTests Things.BodyTests Things.SurfacePatternTests Things.GoalTests Things.WorldOrderTests Reference.AmongReferenceTests
        Reference.MeasuredRunTests Things.WorldReferenceTests" ;;
    *) tests="Tests.$room" ;;
esac
filter=${FILTER:-$(printf 'FullyQualifiedName~%s|' $tests)}
mutate=()
for file in "${@:-**/*.cs}"; do
    mutate+=("\"$room/$file\"")
done

out="$root/artifacts/stryker/$room"
mkdir -p "$out"
cat > "$out/config.json" <<END
{
  "stryker-config": {
    "project": "Football.Physics.csproj",
    "target-framework": "net10.0",
    "configuration": "Release",
    "concurrency": ${CONCURRENCY:-1},
    "mutate": [$(IFS=,; echo "${mutate[*]}")],
    "test-case-filter": "${filter%|}",
    "coverage-analysis": "off",
    "additional-timeout": 20000,
    "ignore-mutations": ["string"],
    "ignore-methods": ["*Exception.ctor", "*Throw*", "Check.*"],
    "reporters": ["cleartext", "json", "html"]
  }
}
END

# Not analysed again: this is about the tests. Coverage is not told by xunit v3's own processes, so each mutant is played against all that were chosen.
cd "$root/tests/Football.Physics.Tests"
export RunAnalyzers=false TreatWarningsAsErrors=false DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 MSBUILDDISABLENODEREUSE=1
dotnet tool restore > /dev/null
# What is left of a run that was stopped is a library with all mutants in it.
built=bin/Release/net10.0/Football.Physics.dll
trap 'if [ -f "$built.stryker-unchanged" ]; then mv -f "$built.stryker-unchanged" "$built"; fi' EXIT
dotnet stryker --config-file "$out/config.json" --output "$out" --skip-version-check
