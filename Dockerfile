# Two stages: everything that compiles stays behind. The runtime packages' names differ between Debian releases, so the
# first stage works them out from what the binary links.
ARG DEBIAN=bookworm

FROM debian:${DEBIAN}-slim AS build
WORKDIR /src
COPY script/setup script/setup
COPY server/docs server/docs
COPY client-examples/studio/package.json client-examples/studio/package-lock.json client-examples/studio/.npmrc client-examples/studio/
RUN script/setup build && { script/setup docs studio || echo "without npm the image has no page to try the API, and no studio"; }
COPY . .
RUN script/studio || echo "without npm the image has no studio"
RUN cmake -B /build -G Ninja -DCMAKE_BUILD_TYPE=Release -DTUFTWAVE_TESTS=OFF \
 && cmake --build /build --target tuftwave-server \
 && strip /build/server/tuftwave-server \
 && ldd /build/server/tuftwave-server | awk '$3 ~ /^\// { print $3 }' | xargs -n1 readlink -f \
    | xargs -n1 dpkg-query -S 2>/dev/null | cut -d: -f1 | sort -u > /build/runtime-packages

FROM debian:${DEBIAN}-slim
LABEL org.opencontainers.image.title="Tuftwave" \
      org.opencontainers.image.description="Strokes in, moving hair out: anime hair as a stateless HTTP service" \
      org.opencontainers.image.licenses="MIT"
COPY --from=build /build/runtime-packages /tmp/runtime-packages
RUN apt-get update \
 && xargs apt-get install -y --no-install-recommends < /tmp/runtime-packages \
 && rm -rf /var/lib/apt/lists/* /tmp/runtime-packages
COPY --from=build /build/server/tuftwave-server /usr/local/bin/tuftwave-server
USER 10001:10001
# A container that publishes a port has to listen to others than itself. It does not start by that alone: whoever runs it
# says who may, with -e TUFTWAVE_KEY_FILE=/run/secrets/keys (mounted, readable by user 10001), or with
# -e TUFTWAVE_INSECURE=yes where something in front of it decides, or the port is published to 127.0.0.1 only.
# The admin port asks nobody for keys: make it 0.0.0.0 only on a network that has probes and scrapers alone.
ENV TUFTWAVE_HOST=0.0.0.0 TUFTWAVE_ADMIN_HOST=127.0.0.1
EXPOSE 8080
STOPSIGNAL SIGTERM
HEALTHCHECK --interval=10s --timeout=3s --start-period=2s CMD ["tuftwave-server", "healthcheck"]
ENTRYPOINT ["tuftwave-server"]
