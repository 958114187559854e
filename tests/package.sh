#!/usr/bin/env bash
# Uses the packages of a release as a stranger would: from its folder, with an empty package cache, on .NET, as a NativeAOT program and on Mono, and in Unity's and Godot's
# packages. Every program prints the golden hashes, which must be those of tests/Golden/golden.txt.
#   tests/package.sh            one line a check; exit code 1 at the first that fails
# Needs mono and mcs (Debian: mono-devel), unzip, and a C compiler for NativeAOT.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD

export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_CLI_UI_LANGUAGE=en
export MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=${UseSharedCompilation:-false}

# Beside other work, a second process of MSBuild costs more than it saves. The golden programs have all processors.
[[ ${CI:-} != true ]] || export DOTNET_PROCESSOR_COUNT=1

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
log=$work/log
export NUGET_PACKAGES=$work/cache   # empty: nothing but the release can supply the package
# shellcheck source=artefacts.sh
source tests/artefacts.sh
golden=$root/tests/Golden/golden.txt

fail() {
  echo "FAIL  $1" >&2
  [[ -s $log ]] && { grep -E "error|FAIL" "$log" | sort -u | head -n 10 || :; tail -n 20 "$log"; } >&2
  exit 1
}

ok() { echo "ok    $1 [$SECONDS s]"; : > "$log"; }

quietly() {
  local what=$1
  shift
  "$@" > "$log" 2>&1 || fail "$what"
}

# same WHAT COMMAND…: what the command prints must be the golden hashes. Profiles are recorded, as .NET does unless told otherwise.
same() {
  local what=$1 said
  shift
  env -u DOTNET_TieredPGO -u DOTNET_PROCESSOR_COUNT "$@" > "$work/hashes" 2> "$log" || fail "$what"
  said=$(tail -n 1 "$log")
  if ! diff "$golden" "$work/hashes" > "$log"; then
    fail "$what: other hashes than tests/Golden/golden.txt ($(grep -c '^>' "$log") of $(wc -l < "$golden") lines differ)"
  fi
  ok "$what: $(wc -l < "$work/hashes") lines as in golden.txt, $(tail -n 1 "$work/hashes")${said:+ [$said]}"
}

# more WHAT COMMAND…: as `same`, in .ci/run --full alone: less common settings of a runtime that the others test already.
more() { [[ ${FOOTBALL_FULL:-} != 1 ]] || same "$@"; }

has() { grep -qF -- "$2" <<< "$1" || fail "$3"; }

# The sources as they are, with a repository of its own: what the test changes there stays there.
copy() {
  local remote
  git clone -q --no-checkout . "$1"
  git -C "$1" remote remove origin
  for remote in $(git remote); do git -C "$1" remote add "$remote" "$(git config "remote.$remote.url")"; done
  git ls-files -co --exclude-standard -z -- .ci src samples/Unity samples/Godot README.md LICENSE BannedSymbols.txt .editorconfig .gitignore .config docs/changelog.md 'Directory.*' global.json \
    | while IFS= read -r -d '' file; do [[ -e $file ]] && printf '%s\0' "$file"; done | tar --null -T - -c | tar -x -C "$1"
}

# --- the package

parts=(Football.Physics Football.Physics.{Thesis,Tracks})
blocks=$root/tests/blocks.py
# page SECTION [N…]: runs the blocks of a section of a page exactly as printed, in a copy of the sources. pack_page: a block that packs, for which the SDK's own packages are in the usual cache.
# Analyzers do not change the bytes; the build of the solution runs them.
page() {
  (cd "$work/one" && RunAnalyzers=false "$blocks" run "$@") > "$work/said" 2> "$log" || { cat "$work/said" >> "$log"; fail "$*"; }
}
pack_page() { (unset NUGET_PACKAGES CI; page "$@"); }
# entries PACKAGE: each entry with its size, time and CRC; but for code compiled ahead of time, and for the lines about the file itself.
entries() { unzip -lv "$1" | grep -v ' runtimes/' | sed '1d;$d'; }

# The code compiled ahead of time needs another restore, so the packages are made in the copy, which no other process builds in.
copy "$work/one"
artefacts packages,unity,godot 'Football.Physics.[0-9]*.nupkg' "$work/one"
feed=$release
package=$feed/Football.Physics.$version.nupkg
ok "packages of the release, $version, validated: the same API on every target"

# A release has code for both systems; one that `artefacts` has just made, for Linux.
ready=(linux-x64)
if [[ ${FOOTBALL_FULL:-} == 1 ]] || grep -q runtimes/win-x64 <(unzip -Z1 "$package"); then ready+=(win-x64); fi
for part in "${parts[@]}"; do
  each=$feed/$part.$version.nupkg
  list=$(unzip -Z1 "$each")
  for target in netstandard2.1 net8.0 net10.0; do
    has "$list" "lib/$target/$part.dll" "$part: no assembly for $target"
    has "$list" "lib/$target/$part.xml" "$part: no documentation for $target"
    has "$(unzip -Z1 "${each%.nupkg}.snupkg")" "lib/$target/$part.pdb" "$part: no symbols for $target"
    documented=$(unzip -p "$each" "lib/$target/$part.xml")
    if grep -qE 'Physics\.(World|Stepper|Goal\.Out|FlightPhase|Batch\.Lanes?\b)' <<< "$documented"; then fail "$part: documentation of what is not public, in $target"; fi
  done
  for system in "${ready[@]}"; do
    for target in net8.0 net10.0; do
      has "$list" "runtimes/$system/lib/$target/$part.dll" "$part: no code compiled ahead of time for $system, $target"
    done
  done
  nuspec=$(unzip -p "$each" "$part.nuspec")
  has "$list" README.md "$part: no README"
  has "$list" icon.png "$part: no icon"
  has "$nuspec" '<license type="expression">MIT</license>' "$part: no licence expression"
  has "$nuspec" '<readme>README.md</readme>' "$part: README not named"
  has "$nuspec" '<icon>icon.png</icon>' "$part: icon not named"
  # The library has no dependency; a part has it alone, and of its own version.
  dependencies=$({ grep -o '<dependency [^>]*>' <<< "$nuspec" || true; } | sort -u)
  if [[ $part == Football.Physics ]]; then
    [[ -z $dependencies ]] || fail "the package has dependencies"
  else
    [[ $dependencies == "<dependency id=\"Football.Physics\" version=\"[$version]\" "* && $(wc -l <<< "$dependencies") == 1 ]] || fail "$part depends on $dependencies"
  fi
  has "$nuspec" '<releaseNotes>## ' "$part: no release notes"
  # What the package depends on, and no tool of the build.
  sbom=$(unzip -p "$each" _manifest/bom.cdx.json)
  listed=$(grep -o '"purl": "[^"]*"' <<< "$sbom" | sort -u)
  expected=$(printf '"purl": "pkg:nuget/%s@'"$version"'"\n' Football.Physics "$part" | sort -u)
  [[ $listed == "$expected" ]] || fail "$part: the SBOM lists $listed"
  readme=$(unzip -p "$each" README.md)
  has "$readme" "# Football.Physics" "$part: the README is not in the package"
  if grep -qE '\]\((docs|src|samples)/' <<< "$readme"; then fail "the README has links that end on a page of a feed"; fi
  if LC_ALL=C grep -qaF "$work" <(unzip -p "$each"); then fail "something in $part names a folder of this machine"; fi
  if grep -qF "$work" <<< "$nuspec"; then fail "$part names a folder of this machine"; fi
done
documented=$(unzip -p "$package" lib/netstandard2.1/Football.Physics.xml)
has "$documented" 'T:FootballPhysics.Ball"' "no documentation of Ball"
has "$documented" 'M:FootballPhysics.Ball.Kick(' "no documentation of Ball.Kick"
ok "contents, ${#parts[@]} packages, $(( $(stat -c %s "$package") / 1024 )) KiB that of the library: 3 assemblies each with documentation and symbols, $(( 2 * ${#ready[@]} )) with code compiled ahead of time, README, icon, licence, release notes, SBOM; no dependency but on the library"

# The build of the solution has these assemblies too: in another folder, with the analyzers, and in .ci/run as on a build server. Code ahead of time is made from them by a tool of
# .NET's own, for a minute: not twice.
published=$(unzip -p "$package" Football.Physics.nuspec | sed -n 's/.*<projectUrl>\(.*\)<.*/\1/p')
# A release that was made elsewhere can have another version and another address than this tree. Otherwise nothing is compiled again: tests run beside this script.
facts=()
[[ $(env -u NUGET_PACKAGES dotnet msbuild src/Football.Physics -restore -t:FindVersion -getProperty:Version) == "$version" ]] || facts+=(MinVerVersionOverride="$version")
[[ -z $published ]] || facts+=(ProjectUrl="$published")
pack_again() { env -u NUGET_PACKAGES "${facts[@]}" dotnet pack -c Release src/Packages.proj -o "$work/feed2"; }
quietly "pack again" pack_again
for part in "${parts[@]}"; do
  each=$part.$version
  diff <(entries "$feed/$each.nupkg") <(entries "$work/feed2/$each.nupkg") > "$log" || fail "packed in another folder, $part.nupkg differs"
  cmp "$feed/$each.snupkg" "$work/feed2/$each.snupkg" > "$log" 2>&1 || fail "packed in another folder, $part.snupkg differs"
  cmp <(unzip -p "$feed/$each.nupkg" _manifest/bom.cdx.json) <(unzip -p "$work/feed2/$each.nupkg" _manifest/bom.cdx.json) > "$log" 2>&1 || fail "packed in another folder, the SBOM of $part differs"
done
ok "deterministic: packed in another folder, the assemblies, documentation, SBOM and .snupkg are the same bytes"

# --- the version: that of a tag, and without a tag that of Directory.Build.props

tagged=$work/tagged
copy "$tagged"
rm -rf "$tagged/.git"
prefix=$(sed -nE 's|.*<VersionPrefix>(.*)</VersionPrefix>.*|\1|p' Directory.Build.props)
in_tagged() { GIT_AUTHOR_NAME=test GIT_AUTHOR_EMAIL=test@example.com GIT_COMMITTER_NAME=test GIT_COMMITTER_EMAIL=test@example.com git -C "$tagged" "$@" > "$log" 2>&1 || fail "git $1"; }
# has_version EXPECTED WHERE
has_version() {
  local found
  found=$(cd "$tagged" && env -u NUGET_PACKAGES dotnet msbuild src/Football.Physics -restore -t:FindVersion -getProperty:Version 2> "$log") || fail "the version $2"
  [[ $found == "$1" ]] || fail "the version $2 is $found, not $1"
}
has_version "$prefix" "without git"
in_tagged init -q
in_tagged commit -q --allow-empty -m first
has_version "$prefix" "without a tag"
in_tagged tag v9.8.7
has_version 9.8.7 "at the tag v9.8.7"
in_tagged commit -q --allow-empty -m second
has_version 9.8.8-alpha.0.1 "one commit after v9.8.7"
git -C "$tagged" rev-parse HEAD > "$tagged/.git/shallow"
has_version "$prefix" "in a shallow clone after a tag"
ok "version: $prefix without git, without a tag and in a shallow clone; 9.8.7 at v9.8.7; 9.8.8-alpha.0.1 after it"

# --- the package for Unity

tarball=$release/com.football.physics-$version.tgz
mkdir "$work/unity"
tar -xzf "$tarball" -C "$work/unity"
manifest=$work/unity/package/package.json
# Links and the version are written when it is packed.
as_committed() { sed -i -e '/Url": /d' -e "s|^  \"version\": \"$version\",|$(grep '^  "version": ' samples/Unity/com.football.physics/package.json)|" "$1"; }
as_committed "$manifest"
diff -r -x '*.dll' -x '*.xml' samples/Unity/com.football.physics "$work/unity/package" > "$log" || fail "the package for Unity is not its folder"
for file in Football.Physics.{dll,xml}; do
  cmp <(unzip -p "$feed/${file%.*}.$version.nupkg" "lib/netstandard2.1/$file") "$work/unity/package/Plugins/$file" > "$log" 2>&1 || fail "the package for Unity has another $file"
done
ok "package for Unity, $(basename "$tarball"): the folder with its $(find "$work/unity/package" -name '*.meta' | wc -l) fixed ids, and the assemblies of the .nupkg"

# Its sources with its assemblies, as the engine compiles them, and a script that uses the namespace Batch: from the archive, with the stand-ins for the engine, in a folder without the repository.
# shim FOLDER TARGET ASSEMBLY: copies a stand-in into the project. The build of the solution has compiled it.
shim() {
  local file=$root/tests/EngineShims/$1/bin/Release/$2/$3.dll
  if [[ ! -e $file ]]; then
    (cd "$root" && env -u NUGET_PACKAGES dotnet build -c Release "tests/EngineShims/$1" -p:RunAnalyzers=false) > "$log" 2>&1 || fail "build of the stand-in $1"
  fi
  cp "$file" "$project/"
}
project=$work/unity-project
mkdir "$project"
tar -xzf "$tarball" -C "$project"
shim UnityEngine netstandard2.1 UnityEngine
cat > "$project/Game.cs" <<'CS'
using FootballPhysics;
using FootballPhysics.Batch;

public static class Game
{
    public static double Longest()
    {
        var launches = new BatchLaunches(1000);
        var flights = new BatchFlights(1000);
        for (int i = 0; i < 1000; i++) launches.Set(i, new Vector3d(0, 0.11, 0), new Vector3d(0, 5 + 0.005 * i, -22), Vector3d.Zero);
        new BallBatch(Scene.Default, BatchSettings.For(Accuracy.Millimeter)).Fly(launches, flights, 1000);
        return flights.Position.Z[999];
    }
}
CS
cat > "$project/Game.csproj" <<'XML'
<Project Sdk="Microsoft.NET.Sdk">
  <PropertyGroup>
    <TargetFramework>netstandard2.1</TargetFramework>
    <LangVersion>9.0</LangVersion>
  </PropertyGroup>
  <ItemGroup>
    <Reference Include="package/Plugins/*.dll;UnityEngine.dll" />
  </ItemGroup>
</Project>
XML
build_project() { (cd "$1" && dotnet build -c Release); }
quietly "the package for Unity in a project of its own" build_project "$project"
ok "package for Unity, compiled from its archive alone with both samples, and a script that uses many balls"

# --- the add-on for Godot

project=$work/godot-project
mkdir "$project"
unzip -q "$release/football-physics-godot-$version.zip" -d "$project"
shim Godot net8.0 GodotSharp
cp "$root"/tests/EngineShims/Godot.Adapter/Generated/*.cs "$project/"
cat > "$project/Game.csproj" <<'XML'
<Project Sdk="Microsoft.NET.Sdk">
  <PropertyGroup>
    <TargetFramework>net8.0</TargetFramework>
    <LangVersion>12.0</LangVersion>
    <DefineConstants>$(DefineConstants);TOOLS;GODOT;GODOT4_6_OR_GREATER</DefineConstants>
  </PropertyGroup>
  <ItemGroup>
    <Reference Include="GodotSharp.dll" />
  </ItemGroup>
  <Import Project="addons/football_physics/football_physics.props" />
</Project>
XML
mkdir "$work/godot-cache"
restore_and_build() { (cd "$project" && NUGET_PACKAGES=$work/godot-cache dotnet build -c Release); }
quietly "the add-on for Godot in a project of its own" restore_and_build
[[ -d $work/godot-cache/football.physics/$version ]] || fail "the project for Godot did not restore the packages of the add-on"
ok "add-on for Godot, compiled from its archive alone; the project takes the packages from the add-on"

# By git URL: a branch with the built package as its only content, cloned as Unity's package manager does. The address is one that only git is told.
address=https://github.com/someone/football
unity_branch() {
  (cd "$work/one" && env -u NUGET_PACKAGES -u CI GIT_CONFIG_COUNT=1 GIT_CONFIG_KEY_0=remote.origin.url "GIT_CONFIG_VALUE_0=$address.git" MinVerVersionOverride="$version" ProjectUrl="$published" GIT_AUTHOR_NAME=test GIT_AUTHOR_EMAIL=test@example.com GIT_COMMITTER_NAME=test GIT_COMMITTER_EMAIL=test@example.com \
    RunAnalyzers=false samples/Unity/build.sh --branch upm)
}
quietly "samples/Unity/build.sh --branch" unity_branch
quietly "git clone of the branch" git clone -q --depth 1 --branch upm "file://$work/one" "$work/upm"
rm -rf "$work/upm/.git"
for link in documentationUrl:Documentation~/index.md changelogUrl:CHANGELOG.md licensesUrl:LICENSE.md; do
  grep -qF "\"${link%%:*}\": \"$address/blob/HEAD/samples/Unity/com.football.physics/${link#*:}\"," "$work/upm/package.json" || fail "the package for Unity has no ${link%%:*}"
done
as_committed "$work/upm/package.json"
diff -r "$work/unity/package" "$work/upm" > "$log" || fail "the branch for Unity is not the package"
before=$(git -C "$work/one" rev-parse upm)
quietly "samples/Unity/build.sh --branch, again" unity_branch
[[ $(git -C "$work/one" rev-parse upm) == "$before" ]] || fail "an unchanged package for Unity makes a commit"
ok "package for Unity by git URL: the branch has the files of the tarball; an unchanged package makes no commit"

# --- the consumer, on .NET

consumer=$work/consumer
mkdir -p "$consumer/tests"
cp -R tests/Golden tests/Package.Consumer tests/Package.Mono "$consumer/tests/"
cd "$consumer/tests/Package.Consumer"

consume() {
  local out=$1
  shift
  dotnet publish -c Release --source "$feed" "-p:FootballPhysicsVersion=$version" --artifacts-path "$work/build/$out" -o "$work/$out" "$@"
}

quietly "consumer" consume ready
[[ $(uname -m) != x86_64 || -e $work/ready/runtimes/linux-x64/lib/net10.0/Football.Physics.dll ]] || fail "the consumer has no code compiled ahead of time"
same "package on .NET, code compiled ahead of time" "$work/ready/consumer"
more "package on .NET, such code alone" env DOTNET_TieredCompilation=0 "$work/ready/consumer"
same "package on .NET, such code, no AVX2, no FMA" env DOTNET_EnableAVX2=0 DOTNET_EnableFMA=0 "$work/ready/consumer"
quietly "consumer of the net10.0 assembly" consume net10 -p:LibraryAsset=net10.0
more "net10.0 assembly on .NET" "$work/net10/consumer"
cp -R "$work/net10" "$work/net8"
unzip -p "$package" lib/net8.0/Football.Physics.dll > "$work/net8/Football.Physics.dll"
more "net8.0 assembly in the same program" "$work/net8/consumer"
quietly "consumer of the netstandard2.1 assembly" consume netstandard -p:LibraryAsset=netstandard2.1
same "netstandard2.1 assembly on .NET" "$work/netstandard/consumer"
same "net10.0 assembly, no tiered compilation" env DOTNET_TieredCompilation=0 "$work/net10/consumer"
more "net10.0 assembly, no profile-guided code" env DOTNET_TieredPGO=0 "$work/net10/consumer"
more "net10.0 assembly, no AVX-512" env DOTNET_EnableAVX512=0 DOTNET_EnableAVX512F=0 "$work/net10/consumer"
more "net10.0 assembly, no FMA" env DOTNET_EnableFMA=0 "$work/net10/consumer"
more "net10.0 assembly, no AVX2" env DOTNET_EnableAVX2=0 "$work/net10/consumer"
more "net10.0 assembly, no AVX2, no FMA" env DOTNET_EnableAVX2=0 DOTNET_EnableFMA=0 "$work/net10/consumer"
more "net10.0 assembly, no AVX" env DOTNET_EnableAVX=0 "$work/net10/consumer"

# --- NativeAOT

# aot RID FOLDER PROPERTY…
aot() {
  dotnet publish -c Release -r "$1" "-p:FootballPhysicsVersion=$version" "-p:RestoreAdditionalProjectSources=$feed" \
    -p:NativeProgram=true --artifacts-path "$work/build/$2" -o "$work/$2" "${@:3}"
}

most_kib=3616   # of the program of one ball; 3584 before the knuckle force of seams

rid=$(dotnet --info | awk '$1 == "RID:" { print $2; exit }')
case $rid in *-arm64) rid=linux-arm64 ;; *) rid=linux-x64 ;; esac
quietly "NativeAOT publish" aot "$rid" aot
if grep -qE 'warning (IL|AOT)' "$log"; then fail "NativeAOT publish has warnings"; fi
[[ ! -e $work/aot/consumer.dll ]] || fail "NativeAOT publish left an assembly"
same "NativeAOT, net9.0 program of $(( $(stat -c %s "$work/aot/consumer") / 1024 )) KiB" "$work/aot/consumer"

quietly "NativeAOT publish, one ball" aot "$rid" small -p:SmallProgram=OneBall
if grep -qE 'warning (IL|AOT)' "$log"; then fail "NativeAOT publish, one ball, has warnings"; fi
kib=$(( $(stat -c %s "$work/small/consumer") / 1024 ))
said=$("$work/small/consumer" 2> "$log") || fail "NativeAOT, one ball"
(( kib <= most_kib )) || fail "NativeAOT, one ball: $kib KiB; allowed: $most_kib"
ok "NativeAOT, one ball: $kib KiB of at most $most_kib; it $said"

# --- Mono

cd "$consumer/tests/Package.Mono"
quietly "build for Mono" dotnet build -c Release "-p:FootballPhysicsVersion=$version" "-p:RestoreAdditionalProjectSources=$feed" \
  --artifacts-path "$work/build/mono" -o "$work/mono"
quietly "mcs" mcs -nologo -out:"$work/mono/host.exe" -r:"$work/mono/golden.dll" -r:Facades/netstandard.dll Host.cs
same "netstandard2.1 assembly on Mono" mono "$work/mono/host.exe"
more "netstandard2.1 assembly on Mono, floats as floats" mono -O=float32 "$work/mono/host.exe"

# Without tail calls: Mono frees the frame of a local before a tail call on that local.
more "netstandard2.1 assembly on Mono, all optimisations" mono -O=all,-tailc "$work/mono/host.exe"

# --- the pages of a new user

pack_page docs/getting-started.md#install 1
page docs/getting-started.md#install 2 3
"$blocks" show docs/getting-started.md#a-first-kick csharp > "$work/MyGame/Program.cs"
page docs/getting-started.md#a-first-kick
"$blocks" show docs/getting-started.md#a-first-kick text > "$work/expected"
diff "$work/expected" "$work/said" > "$log" || fail "docs/getting-started.md: the first kick prints something else than the page"
ok "docs/getting-started.md: $(head -n 1 "$work/said")"

rm -rf "$work/MyGame"
pack_page README.md#install 1
page README.md#install 2
"$blocks" show README.md#ten-lines csharp > "$work/MyGame/Program.cs"
cd "$work/MyGame"
dotnet run -c Release > "$work/said" 2> "$log" || fail "the README's first program"
"$blocks" show README.md#ten-lines text > "$work/expected"
diff "$work/expected" "$work/said" > "$log" || fail "the README's first program prints something else than the README"
ok "README.md, Install, and the first program, $(grep -c . Program.cs) lines in that project: $(tr '\n' ' ' < "$work/said")"

# --- the link to the sources, last: it compiles the copy again

build_copy() { (cd "$work/one" && env -u NUGET_PACKAGES -u CI dotnet build -c Release -f net10.0 --no-restore -p:RunAnalyzers=false src/Football.Physics); }
remotes() { git -C "$work/one" remote; }
for remote in $(remotes); do git -C "$work/one" remote remove "$remote"; done
quietly "build without a remote" build_copy
git -C "$work/one" remote add origin https://github.com/someone/football.git
quietly "build with a remote" build_copy
link=$(cat "$work"/one/src/Football.Physics/obj/Release/net10.0/*.sourcelink.json 2> "$log") || fail "no source link"
has "$link" "someone/football/$(git -C "$root" rev-parse HEAD)/" "source link does not name the commit"
ok "source link: names repository and commit; without a remote the build goes on"
